// Statistics of the contact network.

#include <algorithm>
#include <cmath>
#include <vector>

#include <scree/plugin/probe.hpp>

namespace {

struct ContactsProbe {
  double rattler_below = 2;

  static constexpr scree::About about = {"contacts", "coordination, sliding fraction, overlaps, rattlers",
                                         "Z = (2 C_bodies + C_walls)/N, of bodies that are not fixed\n"
                                         "Z without rattlers: (2 C − N_1)/(N − N_0 − N_1), "
                                         "the mean over the other bodies\n"
                                         "sliding fraction = sliding contacts / contacts",
                                         "David et al. 2005, section 2"};

  void declare(scree::Declaration& d) {
    d.number("rattler_below", rattler_below, "", scree::positive,
             "a body with fewer contacts than this is a rattler, which bears no load");
  }

  void describe(scree_probe_instance& instance) const {
    instance.needs = SCREE_NEEDS_CONTACTS;
    instance.column_count = std::size(names);
    instance.leaves_out = 1;
  }
  scree::ColumnName column(std::uint32_t c) const { return {names[c], units[c], meanings[c]}; }

  void sample(const scree_view& view, const double*, double* row) const {
    const auto is_free = [&](std::uint64_t i) {
      return scree::counts(view, i) && (!view.fixed || !view.fixed[i]);
    };
    double contacts = 0, ends = 0, free = 0, rattlers = 0, ends_of_rattlers = 0, sliding = 0, overlap = 0,
           largest = 0, force = 0;
    std::vector<std::uint32_t> coordination(view.body_count, 0);
    for (std::uint64_t c = 0; c < view.contact_count; ++c) {
      if (!scree::counts_contact(view, c)) continue;
      ++contacts;
      ++coordination[view.contact_a[c]];
      if (view.contact_b[c] < view.body_count) ++coordination[view.contact_b[c]];
      sliding += view.contact_sliding[c];
      overlap += view.contact_overlap[c];
      largest = std::max(largest, view.contact_overlap[c]);
      for (int k = 0; k < 3; ++k) force += view.contact_force[3 * c + k] * view.contact_normal[3 * c + k];
    }
    for (std::uint64_t i = 0; i < view.body_count; ++i) {
      if (!is_free(i)) continue;
      const std::uint32_t n = coordination[i];
      ++free, ends += n;
      if (n < rattler_below) ++rattlers, ends_of_rattlers += n;
    }
    const auto ratio = [](double a, double b) { return b > 0 ? a / b : 0; };
    const double values[] = {contacts,
                             ratio(ends, free),
                             ratio(ends - ends_of_rattlers, free - rattlers),
                             ratio(sliding, contacts),
                             ratio(overlap, contacts),
                             largest,
                             ratio(force, contacts),
                             rattlers};
    std::copy(std::begin(values), std::end(values), row);
  }

 private:
  static constexpr const char* names[] = {"contacts",
                                          "coordination_number",
                                          "coordination_without_rattlers",
                                          "sliding_fraction",
                                          "mean_overlap",
                                          "max_overlap",
                                          "mean_normal_force",
                                          "rattlers"};
  static constexpr const char* units[] = {"", "", "", "", "m", "m", "N", ""};
  static constexpr const char* meanings[] = {
      "number of touching pairs, walls included",
      "contacts per body that is not fixed; one with a wall or a fixed body counts for its body",
      "the same of the bodies that are no rattlers",
      "share of the contacts that slide",
      "over the contacts",
      "of all contacts",
      "over the contacts, above 0 if repulsive",
      "number of bodies that are not fixed with fewer than rattler_below contacts"};
};

}  // namespace

SCREE_PROBE_PLUGIN(ContactsProbe)
