#pragma once

#include <cstdint>

namespace scree {

// Candidate pair: two bodies whose surfaces are nearer than the skin; a < b.
struct NeighbourPair {
  std::uint32_t a, b;
  std::uint8_t image;  // Folding::fold of a − b
  friend bool operator==(const NeighbourPair&, const NeighbourPair&) = default;
};

// Candidate pair of a body and a plane.
struct PlanePair {
  std::uint32_t body, plane;
};

}  // namespace scree
