#pragma once

#include "probe_support.hpp"

#include <random>

namespace scree::test {

// 125 spheres with friction that six walls press together unequally, so that they slide along the sides.
inline Scene pressed_spheres() {
  std::mt19937_64 generator(11);
  std::uniform_real_distribution<double> part(-1, 1);
  std::vector<Body> bodies;
  for (int i = 0; i < 125; ++i) {
    const double radius = 0.005 * (1 + 0.15 * part(generator));
    const Vec3 place = {0.0105 * (i % 5) + 2e-4 * part(generator),
                        0.0105 * (i / 5 % 5) + 2e-4 * part(generator),
                        0.0105 * (i / 25) + 2e-4 * part(generator)};
    bodies.push_back(body(i + 1, radius, 2500 * 4.18879 * radius * radius * radius, place,
                          {0.02 * part(generator), 0.02 * part(generator), 0.02 * part(generator)}));
  }
  Scene s = scene(3, 1e-5, bodies,
                  {{"normal_stiffness", {1e4}},
                   {"restitution", {0.3}},
                   {"tangential_stiffness", {3e3}},
                   {"static_friction", {0.4}}});
  add_boundary(
      s, "box",
      {{"gap", {1e-4}}, {"stress", {0, 4e3}}, {"stress_z", {0, 8e3}}, {"mass", {0.05}}, {"viscosity", {2}}});
  return s;
}

}  // namespace scree::test
