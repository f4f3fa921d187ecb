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
    instance.total_count = total_count;
    instance.largest_count = 1;
  }
  scree::ColumnName column(std::uint32_t c) const {
    static constexpr const char* names[] = {"mean", "largest", "mean_contact_force"};
    static constexpr const char* units[] = {"", "", "N"};
    static constexpr const char* meanings[] = {"mean net force on a body over the mean contact force",
                                               "largest net force on a body over the mean contact force",
                                               "over all contacts, walls included"};
    return {names[c], units[c], meanings[c]};
  }

  void accumulate(const scree_view& part, std::uint32_t, double* totals) const {
    for (std::uint64_t i = part.part_begin; i < part.part_end; ++i) {
      if (!scree::counts(part, i) || (part.fixed && part.fixed[i])) continue;
      Vec3 moving = vector_of(part.force, i);
      for (int k = 0; part.held && k < 3; ++k)
        if (part.held[i] >> k & 1u) moving[k] = 0;
      const double net = norm(moving);
      totals[bodies] += 1;
      totals[net_force] += net;
      totals[largest_net_force] = std::max(totals[largest_net_force], net);
    }
    for (std::uint64_t c = 0; c < part.contact_count; ++c) {
      if (!scree::counts_contact(part, c)) continue;
      const double* f = part.contact_force + 3 * c;
      totals[contacts] += 1;
      totals[contact_force] += std::sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    }
  }
  void sample(const scree_view& view, const double*, double* row) const {
    const double* const totals = view.totals;
    const double mean = totals[contact_force] / totals[contacts];  // NaN without contacts
    row[0] = totals[net_force] / totals[bodies] / mean;
    row[1] = std::max(0.0, totals[largest_net_force]) / mean;
    row[2] = mean;
  }

 private:
  enum Total { bodies, net_force, contacts, contact_force, largest_net_force, total_count };
};

}  // namespace

SCREE_PROBE_PLUGIN(UnbalancedForceProbe)
