// Statistics of the contact network.

#include <algorithm>
#include <iterator>

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
    instance.needs = SCREE_NEEDS_CONTACTS | SCREE_NEEDS_CONTACT_COUNTS;
    instance.column_count = std::size(names);
    instance.leaves_out = 1;
    instance.total_count = total_count;
    instance.largest_count = 1;
  }
  scree::ColumnName column(std::uint32_t c) const { return {names[c], units[c], meanings[c]}; }

  void accumulate(const scree_view& part, std::uint32_t, double* totals) const {
    for (std::uint64_t c = 0; c < part.contact_count; ++c) {
      if (!scree::counts_contact(part, c)) continue;
      totals[contacts] += 1;
      totals[sliding] += part.contact_sliding[c];
      totals[overlap] += part.contact_overlap[c];
      totals[largest_overlap] = std::max(totals[largest_overlap], part.contact_overlap[c]);
      for (int k = 0; k < 3; ++k)
        totals[normal_force] += part.contact_force[3 * c + k] * part.contact_normal[3 * c + k];
    }
    // All contacts of a body that counts do.
    for (std::uint64_t i = part.part_begin; i < part.part_end; ++i) {
      if (!scree::counts(part, i) || (part.fixed && part.fixed[i])) continue;
      const std::uint32_t n = part.contacts_of_body[i];
      totals[bodies] += 1;
      totals[ends] += n;
      if (n >= rattler_below) continue;
      totals[rattlers] += 1;
      totals[ends_of_rattlers] += n;
    }
  }

  void sample(const scree_view& view, const double*, double* row) const {
    const double* const t = view.totals;
    const auto ratio = [](double a, double b) { return b > 0 ? a / b : 0; };
    const double values[] = {t[contacts],
                             ratio(t[ends], t[bodies]),
                             ratio(t[ends] - t[ends_of_rattlers], t[bodies] - t[rattlers]),
                             ratio(t[sliding], t[contacts]),
                             ratio(t[overlap], t[contacts]),
                             std::max(0.0, t[largest_overlap]),
                             ratio(t[normal_force], t[contacts]),
                             t[rattlers]};
    std::copy(std::begin(values), std::end(values), row);
  }

 private:
  enum Total {
    contacts,
    sliding,
    overlap,
    normal_force,
    bodies,
    ends,
    rattlers,
    ends_of_rattlers,
    largest_overlap,
    total_count
  };
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
