#pragma once

#include "error_line.hpp"
#include "sanitized.hpp"
#include "scenes.hpp"

#include <random>

#include <catch2/catch.hpp>

#include <scree/state.hpp>

namespace scree::test {

// From the start of a heap to the state that a test keeps.
inline constexpr int steps_of_heap = sanitized ? 45 : 90;

// Bodies of two sizes that collide: touching and separate pairs, sliding and sticking contacts, walls that
// forces move or periodic faces that bodies cross, a body force, several searches.
inline Scene heap(int dimension, bool periodic) {
  std::mt19937_64 generator(17);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const int per_axis = dimension == 2 ? 16 : 6;
  std::vector<Body> bodies;
  for (int i = 0; i < (dimension == 2 ? 256 : 216); ++i) {
    Vec3 x = {}, v = {}, spin = {};
    for (int k = 0, rest = i; k < dimension; ++k, rest /= per_axis) {
      x[k] = 1.9 * (rest % per_axis) + 0.05 * uniform(generator);
      v[k] = 5 * uniform(generator);
    }
    spin[2] = uniform(generator);
    const double radius = i % 2 ? 1 : 0.8;
    bodies.push_back(body(1000 - i, radius, radius, x, v, spin, dimension));
  }
  Scene s = scene(dimension, 1e-3, bodies,
                  {{"normal_stiffness", {1e4}},
                   {"restitution", {0.8}},
                   {"tangential_stiffness", {3e3}},
                   {"tangential_damping", {1}},
                   {"static_friction", {0.3}}});
  s.min_bodies_per_thread = 1;
  if (periodic)
    add_boundary(
        s, "periodic",
        {{"axes", {3}}, {"lower", {-1, -1, 0}}, {"upper", {1.9 * per_axis - 1, 1.9 * per_axis - 1, 0}}});
  else
    add_boundary(s, "box", {{"stress", {0, 30}}, {"mass", {1000}}, {"viscosity", {10}}, {"x_low", {1}}});
  add_body_force(s, "gravity", {{"acceleration", {0, -10, 0}}});
  return s;
}

// Compares array by array, for a message that names the first difference.
inline void check_same(const State& a, const State& b) {
  REQUIRE(a.arrays().size() == b.arrays().size());
  for (const auto& [path, array] : a.arrays()) {
    INFO(path);
    CHECK(b.at(path) == array);
  }
}

}  // namespace scree::test
