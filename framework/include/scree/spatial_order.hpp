#pragma once

#include <cstdint>
#include <vector>

#include <scree/particles.hpp>

namespace scree {

// Order of bodies along a Morton curve through cells of twice the mean radius: bodies that touch lie near
// each other in memory as well. Bodies of one cell keep their order.
std::vector<std::uint32_t> spatial_order(const std::vector<Body>& bodies, int dimension);

}  // namespace scree
