#pragma once

#include <scree/plugin/abi.h>

namespace scree {

// Sums over columns of the energy balance (J): kinetic of bodies and boundaries, elastic of both springs, and
// all dissipated columns.
double kinetic_energy(const scree_energy& energy);
double elastic_energy(const scree_energy& energy);
double dissipated_energy(const scree_energy& energy);

}  // namespace scree
