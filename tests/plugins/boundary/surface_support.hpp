#pragma once

#include "wall_support.hpp"

#include <string>

#include <scree/wall_surfaces.hpp>

// What tests of moving surfaces share.

namespace scree::test {

// Choices of `control` and `spin_control`.
enum { at_rest, by_displacement, by_velocity, by_force, by_stress, left_out };
enum { spin_at_rest, by_angle, by_spin, by_torque };

inline constexpr double disc_mass = 2, stiffness = 1e4;
inline const Values plate = {
    {"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"radius", {0.2}}, {"mass", {disc_mass}}};

inline Values together(const Values& some, const Values& added) {
  Values all = some;
  all.insert(all.end(), added.begin(), added.end());
  return all;
}
inline void reconfigure(Simulation& s, const std::string& plugin, const Values& values) {
  s.reconfigure_boundary(plugin, parameters(plugin, SCREE_BOUNDARY, values));
  s.apply_reconfiguration();
}
inline Scene far_body(double step) { return scene(3, step, {body(1, 0.01, 0.01, {{0, 0, 9}})}, elastic); }
inline const scree_frame& frame(const Simulation& s) { return s.surfaces().frames[0]; }

}  // namespace scree::test
