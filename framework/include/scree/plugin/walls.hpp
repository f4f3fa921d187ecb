#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include <scree/plugin/abi.h>

namespace scree {

// Index of the innermost wall that is normal to an axis, at its lower end (sign 1) or its upper end (sign −1);
// −1 if there is none.
inline int wall_across(std::span<const scree_plane> walls, int axis, int sign) {
  constexpr double along = 0.999999;
  int innermost = -1;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (!(walls[w].normal[axis] * sign > along)) continue;
    if (innermost < 0 || (walls[w].point[axis] - walls[std::size_t(innermost)].point[axis]) * sign > 0)
      innermost = int(w);
  }
  return innermost;
}

// Height of that wall along the axis (m); NaN if there is none.
inline double wall_height(std::span<const scree_plane> walls, int axis, int sign) {
  const int wall = wall_across(walls, axis, sign);
  return wall < 0 ? std::numeric_limits<double>::quiet_NaN() : walls[std::size_t(wall)].point[axis];
}

}  // namespace scree
