// The energy balance: all stored and dissipated energies.

#include <iterator>

#include <scree/plugin/energies.hpp>
#include <scree/plugin/probe.hpp>

namespace {

struct EnergyProbe {
  static constexpr scree::About about = {
      "energy", "all stored and dissipated energies, and the residual of the balance",
      "residual = stored − stored at the start + dissipated − created − work", "—"};

  void declare(scree::Declaration&) {}
  void describe(scree_probe_instance& instance) const {
    instance.needs = SCREE_NEEDS_ENERGY | SCREE_NEEDS_NO_BODIES;
    instance.column_count = std::size(scree::energies);
  }
  scree::ColumnName column(std::uint32_t c) const {
    return {scree::energies[c].name, "J", scree::energies[c].meaning};
  }
  void sample(const scree_view& view, const double*, double* row) const {
    for (const scree::NamedEnergy& energy : scree::energies) *row++ = view.energy->*energy.member;
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(EnergyProbe)
