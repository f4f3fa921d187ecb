#pragma once

#include <array>
#include <cstdint>

#include <scree/packing/lattice.hpp>

namespace scree::packing {

using SiteCount = std::array<std::int64_t, 3>;

// Position of site (i, j, k) in units of the distance between nearest sites.
Vec3 lattice_site(LatticeKind kind, const SiteCount& index);

// Distance between successive rows or layers along x, y, z in the same units.
Vec3 lattice_step(LatticeKind kind);

// Largest coordinate of any site along x, y, z in the same units; the smallest is 0.
Vec3 lattice_extent(LatticeKind kind, const SiteCount& count);

// Axes along which successive rows or layers are shifted, so that only an even number of them is periodic.
std::array<bool, 3> staggered_axes(LatticeKind kind);

// Smallest count for `total` bodies in a box as near to a cube (square) as the lattice allows.
SiteCount nearest_count(LatticeKind kind, std::int64_t total, const std::array<bool, 3>& periodic);

}  // namespace scree::packing
