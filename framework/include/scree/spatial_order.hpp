#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <scree/pair_search.hpp>
#include <scree/particles.hpp>

namespace scree {

// Indices of the bodies in an order in which bodies that touch are close in memory too: compact tiles (see
// BodyTiles) and, in a tile, a Morton curve through cells of twice the mean radius. Bodies of the same cell
// keep their order.
std::vector<std::uint32_t> spatial_order(std::span<const Sphere> bodies, int dimension);
std::vector<std::uint32_t> spatial_order(const std::vector<Body>& bodies, int dimension);

}  // namespace scree
