#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include <scree/vec.hpp>

namespace scree {

// Which axes are periodic, and between which coordinates.
struct Domain {
  static constexpr std::uint8_t no_shift = 13;

  std::array<bool, 3> periodic = {};
  Vec3 lower = {};  // (m)
  Vec3 upper = {};  // (m)

  bool any_periodic() const { return periodic[0] || periodic[1] || periodic[2]; }
  double length(int axis) const { return upper[axis] - lower[axis]; }

  // Makes a − b that of the nearest image of b, for coordinates within the domain, and tells which it is: one
  // of −1, 0, 1 per axis as a base-3 code with 13 for none.
  std::uint8_t fold(Vec3& a_minus_b) const {
    int code = no_shift;
    for (int k = 0, weight = 1; k < 3; ++k, weight *= 3) {
      if (!periodic[k]) continue;
      const double half = 0.5 * length(k);
      const int turns = (a_minus_b[k] < -half ? 1 : 0) - (a_minus_b[k] > half ? 1 : 0);
      a_minus_b[k] += turns * length(k);
      code += turns * weight;
    }
    return std::uint8_t(code);
  }
  // What to add to a − b for that image.
  Vec3 shift(std::uint8_t code) const {
    Vec3 s = {};
    for (int k = 0, rest = code; k < 3; ++k, rest /= 3)
      if (periodic[k]) s[k] = (rest % 3 - 1) * length(k);
    return s;
  }
};

}  // namespace scree
