#pragma once

#include "scree/packing/packing.hpp"

#include <cstddef>
#include <functional>

namespace scree::packing {

// Two overlapping bodies, by index in the packing; first == second: a body and its own periodic image.
struct ClosePair {
  std::size_t first;
  std::size_t second;
  double distance;  // (m) between the centres of the nearest periodic images

  // Order by index, for the choice among pairs that overlap equally.
  friend bool operator<(const ClosePair& a, const ClosePair& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  }
};

// Calls visit(pair) for each overlapping pair of a packing that passes check(), in no particular order, until
// it returns false.
void visit_close_pairs(const Packing& packing, const std::function<bool(const ClosePair&)>& visit);

}  // namespace scree::packing
