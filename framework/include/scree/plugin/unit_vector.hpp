#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <scree/plugin/vec.hpp>

namespace scree {

// Makes a vector of a scenario one of length 1; false if its length is 0. Scaled by a power of 2, so that no
// square overflows or underflows.
inline bool make_unit(std::array<double, 3>& v) {
  const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (!(largest > 0)) return false;
  const int exponent = std::ilogb(largest);
  for (double& x : v) x = std::ldexp(x, -exponent);
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (double& x : v) x /= length;
  return true;
}

inline Vec3 vector_of(const std::array<double, 3>& v) { return {{v[0], v[1], v[2]}}; }

}  // namespace scree
