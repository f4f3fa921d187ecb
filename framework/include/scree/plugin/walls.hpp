#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <scree/plugin/abi.h>

namespace scree {

// Index of the innermost wall that is normal to an axis, at its lower end (sign 1) or its upper end (sign
// −1); −1 if there is none. absent: of each wall, whether it is not there; such a wall counts only where no
// other is.
inline int wall_across(std::span<const scree_plane> walls, int axis, int sign,
                       const std::uint8_t* absent = nullptr) {
  constexpr double along = 0.999999;
  int innermost = -1;
  const auto is_there = [&](int w) { return !absent || !absent[w]; };
  for (int w = 0; w < int(walls.size()); ++w) {
    if (!(walls[std::size_t(w)].normal[axis] * sign > along)) continue;
    const auto inwards = [&](int v) { return sign * walls[std::size_t(v)].point[axis]; };
    if (innermost < 0 || (is_there(w) && !is_there(innermost)) ||
        (is_there(w) == is_there(innermost) && inwards(w) > inwards(innermost)))
      innermost = w;
  }
  return innermost;
}

// Height of that wall along the axis (m); NaN if there is none.
inline double wall_height(std::span<const scree_plane> walls, int axis, int sign,
                          const std::uint8_t* absent = nullptr) {
  const int wall = wall_across(walls, axis, sign, absent);
  return wall < 0 ? std::numeric_limits<double>::quiet_NaN() : walls[std::size_t(wall)].point[axis];
}

// Force (N) with which contacts press on a wall across an axis, above 0 in compression: the mean of the walls
// at both ends, or of the one that is there; NaN without walls at both ends.
inline double pressing_force(std::span<const scree_plane> walls, const scree_load* loads, int axis,
                             const std::uint8_t* absent = nullptr) {
  const int low = wall_across(walls, axis, 1, absent), high = wall_across(walls, axis, -1, absent);
  if (low < 0 || high < 0) return std::numeric_limits<double>::quiet_NaN();
  const bool both = !absent || absent[low] == absent[high];
  return (both ? 0.5 : 1) * (loads[high].force[axis] - loads[low].force[axis]);
}

}  // namespace scree
