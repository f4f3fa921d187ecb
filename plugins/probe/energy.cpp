// The energy balance: all stored and dissipated energies.

#include <scree/plugin/probe.hpp>

namespace {

struct EnergyProbe {
  struct Entry {
    const char* name;
    double scree_energy::*member;
  };
  static constexpr Entry entries[] = {{"kinetic_translation", &scree_energy::kinetic_translation},
                                      {"kinetic_rotation", &scree_energy::kinetic_rotation},
                                      {"kinetic_boundary", &scree_energy::kinetic_boundary},
                                      {"elastic_normal", &scree_energy::elastic_normal},
                                      {"elastic_tangential", &scree_energy::elastic_tangential},
                                      {"potential", &scree_energy::potential},
                                      {"dissipated_normal", &scree_energy::dissipated_normal},
                                      {"dissipated_tangential", &scree_energy::dissipated_tangential},
                                      {"dissipated_rolling", &scree_energy::dissipated_rolling},
                                      {"dissipated_friction", &scree_energy::dissipated_friction},
                                      {"dissipated_release", &scree_energy::dissipated_release},
                                      {"dissipated_translation", &scree_energy::dissipated_translation},
                                      {"dissipated_rotation", &scree_energy::dissipated_rotation},
                                      {"dissipated_boundary", &scree_energy::dissipated_boundary},
                                      {"created", &scree_energy::created},
                                      {"work", &scree_energy::work},
                                      {"residual", &scree_energy::residual}};

  static constexpr scree::About about = {
      "energy", "all stored and dissipated energies, and the residual of the balance",
      "residual = stored − stored at the start + dissipated − created − work", "—"};

  void declare(scree::Declaration&) {}
  void describe(scree_probe_instance& instance) const {
    instance.needs = SCREE_NEEDS_ENERGY;
    instance.column_count = std::size(entries);
  }
  scree::ColumnName column(std::uint32_t c) const { return {entries[c].name, "J"}; }
  void sample(const scree_view& view, const double*, double* row) const {
    for (const Entry& entry : entries) *row++ = view.energy->*entry.member;
  }
};

}  // namespace

SCREE_PROBE_PLUGIN(EnergyProbe)
