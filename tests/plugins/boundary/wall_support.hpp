#pragma once

#include "scenes.hpp"

// What tests of walls share.

namespace scree::test {

inline constexpr double unit_round_off = 1.2e-16;
inline const Values elastic = {{"normal_stiffness", {1e4}}, {"normal_damping", {0}}};

// Choices of `control`.
enum { box_stress, box_fixed, box_displacement, box_velocity, box_strain_rate, box_servo, box_massless };
enum {
  plane_fixed,
  plane_displacement,
  plane_velocity,
  plane_stress,
  plane_force,
  plane_servo,
  plane_massless
};

// Of the first wall, along z.
inline double height_of_wall(const Simulation& s) { return s.planes()[0].point[2]; }
inline double speed_of_wall(const Simulation& s) { return s.planes()[0].velocity[2]; }

}  // namespace scree::test
