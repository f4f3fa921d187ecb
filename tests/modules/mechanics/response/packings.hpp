#pragma once

#include "scenes.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Core>

#include <scree/branching.hpp>
#include <scree/response/degrees_of_freedom.hpp>

// Small packings, and their stiffness by differences of the forces that the kernel computes.

namespace scree::test {

using Matrix = Eigen::MatrixXd;

// So heavy that forces do not move it: bodies move as their velocities say.
constexpr double heavy = 1e30;

// Bodies of radius 1 on a floor, pressed together, with various overlaps.
inline Scene heap(int dimension, const Values& law, const std::string& plugin = "linear_spring_dashpot",
                  double mass = heavy) {
  std::vector<Vec3> centres = {{{0, 0.93, 0}}, {{1.9, 0.95, 0}}, {{0.96, 2.55, 0}}, {{2.8, 2.6, 0}}};
  if (dimension == 3)
    centres = {
        {{0, 0.93, 0}}, {{1.9, 0.95, 0.1}}, {{0.96, 0.94, 1.6}}, {{0.97, 2.4, 0.55}}, {{2.6, 2.45, 1.3}}};
  const double radii[] = {1, 1.04, 0.97, 1.02, 0.99};
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < centres.size(); ++i)
    bodies.push_back(body(std::int64_t(i), radii[i], mass, centres[i], {}, {}, dimension));
  Scene s = scene(dimension, 1e-3, std::move(bodies), law, plugin);
  add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}}, "floor");
  return s;
}

// Sets the velocity (m/s), and behind the dimensions the spin (rad/s), of component k of a body.
inline double& motion(Body& body, int dimension, int k) {
  if (k < dimension) return body.velocity[k];
  return body.spin[dimension == 2 ? 2 : k - dimension];
}

// The state after a step in which bodies moved by some hundredths of a radius and turned by as much, at rest.
inline State strained(Scene scene) {
  const Scene at_rest = scene;
  const int components = scene.dimension == 2 ? 3 : 6;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    for (int k = 0; k < components; ++k)
      motion(scene.bodies[i], scene.dimension, k) =
          0.02 * std::sin(1.0 + 2.3 * double(i) + 1.7 * k) / scene.step;
  Simulation moving(scene);
  moving.step();
  const State moved = moving.state();
  Scene stopped = at_rest;
  stopped.bodies = present_bodies(moved);
  for (Body& body : stopped.bodies) body.velocity = body.spin = {};
  return Simulation(stopped, moved, Branching()).state();
}

// Forces and torques of all bodies, and forces of contacts and pressing forces on the walls that are
// numbered, along their normals, as a vector. The walls are those of a box, the only boundary.
inline Eigen::VectorXd loads(const Simulation& s, const response::DegreesOfFreedom& freedom) {
  Eigen::VectorXd all(freedom.size());
  const Particles& p = s.particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (int k = 0; k < freedom.dimension(); ++k) all[freedom.translation(i, k)] = p.force()[k][i];
    for (int k = 0; k < freedom.spins(); ++k)
      if (freedom.rotation(i, k) >= 0) all[freedom.rotation(i, k)] = p.torque()[p.spin_axes().first + k][i];
  }
  if (freedom.walls() == 0) return all;
  const State state = s.state();
  for (std::size_t w = 0; w < freedom.walls(); ++w) {
    if (freedom.wall(w) < 0) continue;
    all[freedom.wall(w)] = std::get<std::vector<double>>(state.at("walls/0/state").values)[w];
    for (int k = 0; k < 3; ++k) all[freedom.wall(w)] += s.loads()[w].force[k] * s.planes()[w].normal[k];
  }
  return all;
}

// A scene with the bodies of a state, in which one component of the motion of body i is `rate`.
inline Scene with_motion(Scene scene, const State& state, std::size_t i, int k, double rate) {
  scene.bodies = present_bodies(state);
  motion(scene.bodies[i], scene.dimension, k) = rate;
  return scene;
}

// Calls use(column, body, component) for all degrees of freedom.
template <class Use>
void each_motion(const response::DegreesOfFreedom& freedom, const Use& use) {
  for (std::size_t i = 0; i < freedom.bodies(); ++i) {
    for (int k = 0; k < freedom.dimension(); ++k) use(freedom.translation(i, k), i, k);
    for (int k = 0; k < freedom.spins(); ++k)
      if (freedom.rotation(i, k) >= 0) use(freedom.rotation(i, k), i, freedom.dimension() + k);
  }
}

// Each body is moved in a step of its own from the state, so that springs follow. Differences of fourth
// order.
inline Matrix stiffness_by_differences(const Scene& scene, const State& state,
                                       const response::DegreesOfFreedom& freedom) {
  const double length = 2e-4;
  Matrix stiffness(freedom.size(), freedom.size());
  each_motion(freedom, [&](Eigen::Index column, std::size_t i, int k) {
    const auto after = [&](double steps) {
      Simulation moved(with_motion(scene, state, i, k, steps * length / scene.step), state, Branching());
      moved.step();
      return loads(moved, freedom);
    };
    stiffness.col(column) = -(8 * (after(1) - after(-1)) - (after(2) - after(-2))) / (12 * length);
  });
  return stiffness;
}

// Differences of the forces at two velocities or spins of each body, in the same places.
inline Matrix damping_by_differences(const Scene& scene, const State& state,
                                     const response::DegreesOfFreedom& freedom) {
  const double rate = 1e-3;
  Matrix damping(freedom.size(), freedom.size());
  each_motion(freedom, [&](Eigen::Index column, std::size_t i, int k) {
    const Simulation more(with_motion(scene, state, i, k, rate), state, Branching());
    const Simulation less(with_motion(scene, state, i, k, -rate), state, Branching());
    damping.col(column) = -(loads(more, freedom) - loads(less, freedom)) / (2 * rate);
  });
  return damping;
}

}  // namespace scree::test
