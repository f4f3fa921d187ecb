#pragma once

#include <iterator>

#include <scree/plugin/abi/probe.h>

namespace scree {

// The energies of the balance by name, in the order of scree_energy.
struct NamedEnergy {
  const char* name;
  double scree_energy::*member;
  const char* meaning;
};
inline constexpr NamedEnergy energies[] = {
    {"kinetic_translation", &scree_energy::kinetic_translation, "½ m v² of the bodies"},
    {"kinetic_rotation", &scree_energy::kinetic_rotation, "½ I ω² of the bodies"},
    {"kinetic_boundary", &scree_energy::kinetic_boundary, "of walls with mass"},
    {"elastic_normal", &scree_energy::elastic_normal, "in normal springs"},
    {"elastic_tangential", &scree_energy::elastic_tangential, "in tangential springs"},
    {"potential", &scree_energy::potential, "of body forces, as gravity"},
    {"dissipated_normal", &scree_energy::dissipated_normal, "by normal dashpots"},
    {"dissipated_tangential", &scree_energy::dissipated_tangential, "by tangential dashpots"},
    {"dissipated_rolling", &scree_energy::dissipated_rolling, "by rolling resistance"},
    {"dissipated_friction", &scree_energy::dissipated_friction, "by slip"},
    {"dissipated_release", &scree_energy::dissipated_release,
     "springs let go at the end of a contact or by a change of stiffness"},
    {"dissipated_translation", &scree_energy::dissipated_translation, "by drag on the velocity"},
    {"dissipated_rotation", &scree_energy::dissipated_rotation, "by drag on the spin"},
    {"dissipated_boundary", &scree_energy::dissipated_boundary, "by viscosity of walls"},
    {"created", &scree_energy::created, "by contact laws that are known to create energy"},
    {"work", &scree_energy::work, "done by walls, and by what groups hold, move or load, on the bodies"},
    {"residual", &scree_energy::residual, "what no other column accounts for"}};
static_assert(sizeof(scree_energy) == sizeof(double) * std::size(energies));

}  // namespace scree
