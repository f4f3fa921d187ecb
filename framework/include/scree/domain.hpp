#pragma once

#include <array>
#include <cstdint>

#include <scree/plugin/vec.hpp>

namespace scree {

// Which axes are periodic, and between which coordinates.
struct Domain {
  static constexpr std::uint8_t no_shift = 13;

  std::array<bool, 3> periodic = {};
  Vec3 lower = {};  // (m)
  Vec3 upper = {};  // (m)

  bool any_periodic() const { return periodic[0] || periodic[1] || periodic[2]; }
  double length(int axis) const { return upper[axis] - lower[axis]; }

  // What to add to a − b for an image of a pair.
  Vec3 shift(std::uint8_t code) const {
    Vec3 s = {};
    for (int k = 0, rest = code; k < 3; ++k, rest /= 3)
      if (periodic[k]) s[k] = (rest % 3 - 1) * length(k);
    return s;
  }
};

}  // namespace scree
