#pragma once

#include <vector>

#include <scree/pictures/frame.hpp>

namespace scree::pictures {

// Quantities of single bodies from their contacts; empty if the frame does not say whose contacts they are.

// Magnitude of the largest contact force (N).
std::vector<double> largest_forces(const Frame& frame);
// Mean normal stress by Love and Weber, Σ_c f_n l/(D V), with the arms l to the middle of the overlap (Pa).
std::vector<double> pressures(const Frame& frame);
// The whole tensor, symmetric part, above 0 in compression (Pa) (6N): xx, yy, zz, xy, yz, xz, the order of
// VTK.
std::vector<double> stresses(const Frame& frame);

}  // namespace scree::pictures
