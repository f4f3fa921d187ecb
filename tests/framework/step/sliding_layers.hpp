#pragma once

#include "motion/driven.hpp"

#include <vector>

#include <scree/plugin/program.hpp>
#include <scree/spatial_order.hpp>

namespace scree::test {

// Layers of touching bodies that pass each other closely, between walls and periodic faces; some bodies are
// held in part, loaded or fixed, so that the others push each other aside.
// times: as long along two axes, so that tiles border on several others from 2 on.
inline Scene sliding_layers(int dimension, int times = 1) {
  const int columns = times * (dimension == 2 ? 64 : 16), rows = dimension == 2 ? times * 34 : 15,
            depth = dimension == 2 ? 1 : times * 10;
  const double spacing = 1.96, height = 2.01;
  std::vector<Body> bodies;
  for (int i = 0; i < columns * rows * depth; ++i) {
    const int row = i / columns % rows;
    // Along the axis that the order in memory divides first.
    const int along = dimension == 2 ? 0 : 2;
    Vec3 x = {}, v = {};
    x[along] = spacing * (i % columns);
    x[1] = height * row;
    if (dimension == 3) x[0] = spacing * (i / columns / rows) + (row % 2 ? 0.3 : 0);
    v[along] = row % 2 ? 2 : -2;
    bodies.push_back(body(i, 1 - 0.02 * (i % 3), 1, x, v, {{0, 0, 0.1 * (i % 5)}}, dimension));
  }
  std::vector<Body> sorted;
  for (const std::uint32_t i : spatial_order(bodies, dimension)) sorted.push_back(bodies[i]);
  Scene s = scene(dimension, 0.02, sorted,
                  {{"normal_stiffness", {100}},
                   {"restitution", {0.8}},
                   {"tangential_stiffness", {40}},
                   {"tangential_damping", {0.1}},
                   {"static_friction", {0.3}}});
  add_boundary(s, "periodic",
               {{"axes", {dimension == 2 ? 0.0 : 4.0}},
                {"lower", {-1, 0, -1}},
                {"upper", {spacing * (dimension == 2 ? columns : depth) - 1, 1, spacing * columns - 1}}});
  add_boundary(s, "plane", {{"point", {0, -0.97, 0}}, {"normal", {0, 1, 0}}}, "low");
  add_boundary(s, "plane", {{"point", {0, height * (rows - 1) + 0.97, 0}}, {"normal", {0, -1, 0}}}, "high");
  add_body_force(s, "gravity", {{"acceleration", {0.01, -0.02, 0}}});
  BodyGroup shaken = group_of("shaken", {5, 1500}), loaded = group_of("loaded", {7, 1900});
  shaken.velocity[0] = {Program::sine, 0, 0.5, 2, 0};
  loaded.load[0] = {Program::constant, 0.5};
  for (const std::uint32_t i : shaken.bodies) s.bodies[i].held = bit(0), s.bodies[i].velocity = {};
  s.bodies[9].held = bit(1);
  s.bodies[1700].fixed = true;
  s.bodies[1700].velocity = {};
  s.groups = {shaken, loaded};
  s.orientations = true;
  s.min_bodies_per_thread = 1;
  return s;
}

}  // namespace scree::test
