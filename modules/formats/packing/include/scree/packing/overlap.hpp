#pragma once

#include <cstdint>
#include <optional>

#include <scree/packing/packing.hpp>

namespace scree::packing {

// Two overlapping bodies, or a body that overlaps its own periodic image (then both ids are equal).
struct Overlap {
  std::int64_t first = 0;   // id
  std::int64_t second = 0;  // id
  double depth = 0.0;       // (m) sum of the radii minus the distance of the centres, positive
};

// Deepest overlap above the tolerance (m), nearest periodic images included; empty if there is none.
// Time is proportional to bodies times size classes. The search stops after 1000 overlaps per body and
// returns the deepest so far. Throws Error if check(packing) does.
std::optional<Overlap> find_overlap(const Packing& packing, double tolerance = 0.0);

}  // namespace scree::packing
