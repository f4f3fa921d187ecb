#pragma once

#include "sphere_pair.hpp"

// The law for spheres as most tests use it: units of 1, springs of about 100 N/m at overlaps of 0.1 m.

namespace scree::test {

// Unit vectors, quaternions and positions are rounded to 1.1e-16; ten roundings of radii of about 1 m.
inline constexpr double pose_round_off = 1.2e-15;

inline Values sphere_values(bool hertz, double friction) {
  if (hertz)
    return {{"normal", {1}}, {"youngs_modulus", {300}}, {"poissons_ratio", {0.3}}, {"friction", {friction}}};
  return {{"normal", {0}},
          {"normal_stiffness", {100}},
          {"normal_damping", {0}},
          {"tangential_stiffness", {80}},
          {"static_friction", {friction}}};
}

inline SpherePair sphere_pair(const Values& values, double radius_a, double radius_b,
                              const SpherePose& start) {
  return SpherePair("sphere_path_independent", values, radius_a, radius_b, start);
}

}  // namespace scree::test
