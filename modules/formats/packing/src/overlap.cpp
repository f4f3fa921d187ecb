#include "scree/packing/overlap.hpp"

#include "close_pairs.hpp"

#include <algorithm>
#include <cstddef>

namespace scree::packing {

std::optional<Overlap> find_overlap(const Packing& packing, double tolerance) {
  check(packing);
  constexpr std::size_t max_per_body = 1000;
  std::optional<Overlap> deepest;
  std::size_t left = max_per_body * packing.bodies.size();
  ClosePairs(packing).for_each([&](const ClosePair& pair) {
    const Body& a = packing.bodies[pair.first];
    const Body& b = packing.bodies[pair.second];
    const double depth = a.radius + b.radius - pair.distance;
    if (depth > tolerance && (!deepest || depth > deepest->depth)) {
      deepest = Overlap{std::min(a.id, b.id), std::max(a.id, b.id), depth};
    }
    return --left > 0;
  });
  return deepest;
}

}  // namespace scree::packing
