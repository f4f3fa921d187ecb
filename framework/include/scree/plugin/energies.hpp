#pragma once

#include <iterator>

#include <scree/plugin/abi/probe.h>

namespace scree {

// The energies of the balance by name, in the order of scree_energy.
struct NamedEnergy {
  const char* name;
  double scree_energy::*member;
};
inline constexpr NamedEnergy energies[] = {{"kinetic_translation", &scree_energy::kinetic_translation},
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
static_assert(sizeof(scree_energy) == sizeof(double) * std::size(energies));

}  // namespace scree
