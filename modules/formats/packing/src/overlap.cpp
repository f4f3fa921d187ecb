#include "scree/packing/overlap.hpp"

#include "close_pairs.hpp"

#include <algorithm>
#include <cstddef>

namespace scree::packing {

std::optional<Overlap> find_overlap(const Packing& packing, double tolerance) {
  check(packing);
  constexpr std::size_t max_per_body = 1000;
  std::optional<ClosePair> deepest;
  double deepest_depth = tolerance;
  std::size_t left = max_per_body * packing.bodies.size();
  visit_close_pairs(packing, [&](const ClosePair& pair) {
    const double depth =
        packing.bodies[pair.first].radius + packing.bodies[pair.second].radius - pair.distance;
    if (depth > deepest_depth || (deepest && depth == deepest_depth && pair < *deepest)) {
      deepest = pair;
      deepest_depth = depth;
    }
    return --left > 0;
  });
  if (!deepest) return std::nullopt;
  const std::int64_t first = packing.bodies[deepest->first].id, second = packing.bodies[deepest->second].id;
  return Overlap{std::min(first, second), std::max(first, second), deepest_depth};
}

}  // namespace scree::packing
