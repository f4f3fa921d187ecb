// How far a packing is from equilibrium, by forces.

#include <algorithm>
#include <cmath>
#include <iterator>

#include <scree/plugin/probe.hpp>
#include <scree/plugin/vec.hpp>

namespace {

using scree::Vec3;
using scree::vector_of;

struct UnbalancedForceProbe {
  static constexpr scree::About about = {
      "unbalanced_force", "net forces on bodies over the mean contact force: 0 in equilibrium",
      "mean = (Σ |F_i|/N)/f,   largest = max |F_i|/f,   f = Σ |f_c|/C\n"
      "F_i: net force on body i that is not fixed, along axes in which it is not, body forces included; f_c: force of\n"
      "contact c, walls included.\n"
      "Without contacts there is no value.",
      "the criterion of PFC and YADE"};

  void declare(scree::Declaration&) {}
  void describe(scree_probe_instance& instance) const {
    instance.needs = SCREE_NEEDS_CONTACTS;
    instance.column_count = 3;
    instance.leaves_out = 1;
  }
  scree::ColumnName column(std::uint32_t c) const {
    static constexpr const char* names[] = {"mean", "largest", "mean_contact_force"};
    static constexpr const char* units[] = {"", "", "N"};
    static constexpr const char* meanings[] = {"mean net force on a body over the mean contact force",
                                               "largest net force on a body over the mean contact force",
                                               "over all contacts, walls included"};
    return {names[c], units[c], meanings[c]};
  }

  void sample(const scree_view& view, const double*, double* row) const {
    double sum = 0, largest = 0, force = 0, contacts = 0, bodies = 0;
    for (std::uint64_t i = 0; i < view.body_count; ++i) {
      if (!scree::counts(view, i) || (view.fixed && view.fixed[i])) continue;
      Vec3 moving = vector_of(view.force, i);
      for (int k = 0; view.held && k < 3; ++k)
        if (view.held[i] >> k & 1u) moving[k] = 0;
      const double net = norm(moving);
      sum += net;
      largest = std::max(largest, net);
      ++bodies;
    }
    for (std::uint64_t c = 0; c < view.contact_count; ++c) {
      if (!scree::counts_contact(view, c)) continue;
      const double* f = view.contact_force + 3 * c;
      ++contacts;
      force += std::sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    }
    const double mean = force / contacts;  // NaN without contacts
    row[0] = sum / bodies / mean;
    row[1] = largest / mean;
    row[2] = mean;
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(UnbalancedForceProbe)
