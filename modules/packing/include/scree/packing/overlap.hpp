#pragma once

#include <cstdint>
#include <optional>

#include <scree/packing/packing.hpp>

namespace scree::packing {

// Two bodies that interpenetrate, or one that meets its own periodic image (then both ids are the same).
struct Overlap {
  std::int64_t first = 0;   // id
  std::int64_t second = 0;  // id
  double depth = 0.0;       // (m) sum of the radii minus the distance of the centres, positive
};

// Deepest overlap that exceeds the tolerance (m), nearest periodic images included; none if there is none.
// Time is proportional to bodies times size classes. Where bodies pile up without measure the search stops
// after 1000 overlaps per body and returns the deepest so far. Throws Error where check(packing) would.
std::optional<Overlap> find_overlap(const Packing& packing, double tolerance = 0.0);

}  // namespace scree::packing
