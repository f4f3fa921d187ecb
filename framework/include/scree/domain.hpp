#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include <scree/plugin/vec.hpp>

namespace scree {

// The periodic axes and their limits. `no_shift` is the image code of a pair that crosses no periodic face.
struct Domain {
  static constexpr std::uint8_t no_shift = 13;

  std::array<bool, 3> periodic = {};
  Vec3 lower = {};  // (m)
  Vec3 upper = {};  // (m)

  bool any_periodic() const { return periodic[0] || periodic[1] || periodic[2]; }
  double length(int axis) const { return upper[axis] - lower[axis]; }

  // Whole periods (m) by which a coordinate, or a place, lies beyond the limits: bodies are folded into the
  // period at searches alone. 0 inside, and along axes that are not periodic.
  double beyond(int axis, double x) const {
    if (!periodic[axis] || (x >= lower[axis] && x < upper[axis])) return 0;
    return std::floor((x - lower[axis]) / length(axis)) * length(axis);
  }
  Vec3 beyond(const Vec3& x) const { return {{beyond(0, x[0]), beyond(1, x[1]), beyond(2, x[2])}}; }

  // Vector to add to x_a − x_b for the periodic image `code` (m); `code` holds one base-3 digit per axis.
  Vec3 shift(std::uint8_t code) const {
    Vec3 s = {};
    for (int k = 0, rest = code; k < 3; ++k, rest /= 3)
      if (periodic[k]) s[k] = (rest % 3 - 1) * length(k);
    return s;
  }
};

}  // namespace scree
