#pragma once

#include <cstdint>
#include <vector>

#include <scree/domain.hpp>
#include <scree/particles.hpp>

namespace scree {

// Two bodies whose surfaces are nearer than the skin; a < b.
struct NeighbourPair {
  std::uint32_t a, b;
  std::uint8_t image;  // Domain::fold of a − b
  friend bool operator==(const NeighbourPair&, const NeighbourPair&) = default;
};

// Finds all pairs with |x_a − x_b| < R_a + R_b + skin, sorted by a, then b. Positions must lie in the domain.
// Cells of a hierarchy of sizes: a body is filed by its own size and looks only at its own and coarser
// levels, so that size ratios of 1:100 cost no more than 1:2. Throws Error if a periodic length is under
// twice the largest reach, where images would be ambiguous.
std::vector<NeighbourPair> find_neighbours(const Particles& particles, const Domain& domain, double skin);

}  // namespace scree
