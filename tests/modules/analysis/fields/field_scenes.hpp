#pragma once

#include "scenes.hpp"

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <scree/fields/field_grid.hpp>
#include <scree/fields/field_input.hpp>
#include <scree/plugin/program.hpp>

// Dense agitated packings with friction, dashpots and gravity, in units in which radii and masses are near 1.

namespace scree::test {

inline constexpr double pitch = 1.9;  // of the lattice on which the bodies start; radii are 0.9 to 1

struct PackingScene {
  std::string name;
  int dimension = 3;
  std::vector<double> periodic = {};  // one axis, or x and y; walls along the others
  bool groups = false;                // fixed, held, moved and loaded bodies
  double damping = 0;                 // background damping
  std::string law = "linear_spring_dashpot";
};

inline const std::vector<PackingScene> packing_scenes = {
    {"box in 3D"},
    {"box in 2D", 2},
    {"periodic along x and y in 3D", 3, {0, 1}},
    {"periodic along all axes in 2D", 2, {0, 1}},
    {"with groups in 3D", 3, {0}, true},
    {"with groups in 2D", 2, {}, true},
    {"with damping in 3D", 3, {}, false, 0.5},
    {"hertz_mindlin in 3D", 3, {2}, false, 0, "hertz_mindlin"}};

inline int cells_along(int dimension, int k) { return dimension == 2 ? (k == 2 ? 1 : 7) : (k == 2 ? 4 : 5); }

inline std::vector<Body> agitated_bodies(int dimension) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> part(-1, 1);
  std::vector<Body> bodies;
  for (int z = 0; z < cells_along(dimension, 2); ++z)
    for (int y = 0; y < cells_along(dimension, 1); ++y)
      for (int x = 0; x < cells_along(dimension, 0); ++x) {
        Vec3 at = {{(x + 0.5) * pitch, (y + 0.5) * pitch, dimension == 2 ? 0 : (z + 0.5) * pitch}}, v = {};
        for (int k = 0; k < dimension; ++k) at[k] += 0.08 * part(random), v[k] = part(random);
        const double radius = 0.95 + 0.05 * part(random);
        // Numbers that are not in the order of places.
        const auto id = std::int64_t(1000 - 7 * bodies.size());
        bodies.push_back(body(id, radius, radius * radius * radius, at, v, {}, dimension));
      }
  return bodies;
}

inline void add_enclosure(Scene& s, const PackingScene& packing) {
  std::vector<bool> periodic(3, false);
  for (const double k : packing.periodic) periodic[std::size_t(k)] = true;
  std::vector<double> upper(3, 0);
  for (int k = 0; k < packing.dimension; ++k)
    upper[std::size_t(k)] = cells_along(packing.dimension, k) * pitch;
  if (!packing.periodic.empty()) {
    const double choice = packing.periodic.size() == 1 ? packing.periodic[0] : 3;  // x|y|z|xy
    add_boundary(s, "periodic", {{"axes", {choice}}, {"lower", {0, 0, 0}}, {"upper", upper}});
  }
  for (std::size_t k = 0; k < std::size_t(packing.dimension); ++k)
    for (const double side : {1.0, -1.0}) {
      if (periodic[k]) continue;
      std::vector<double> point(3, 0), normal(3, 0);
      point[k] = side > 0 ? 0 : upper[k];
      normal[k] = side;
      add_boundary(s, "plane", {{"point", point}, {"normal", normal}},
                   "xyz"[k] + std::string(side > 0 ? "-" : "+"));
    }
}

inline void add_groups(Scene& s) {
  s.bodies[0].fixed = true;
  s.bodies[3].fixed = s.bodies[8].fixed = true;
  for (const std::size_t i : {0u, 3u, 8u}) s.bodies[i].velocity = {};
  s.bodies[12].held = 1;
  BodyGroup moved, loaded;
  moved.name = "moved";
  moved.bodies = {3, 8};
  moved.velocity[1] = {Program::sine, 0.02, 0.3, 3, 0.2};
  loaded.name = "loaded";
  loaded.bodies = {12, 17, 20};
  loaded.load[1] = {Program::sine, 2, 4, 5, 0};
  s.groups = {moved, loaded};
}

inline Scene scene_of(const PackingScene& packing) {
  const bool hertz = packing.law == "hertz_mindlin";
  Values law = {{"normal_stiffness", {1000}},
                {"restitution", {0.8}},
                {"tangential_stiffness", {300}},
                {"tangential_damping", {0.5}},
                {"static_friction", {0.4}}};
  if (hertz)
    law = {
        {"youngs_modulus", {2000}}, {"poissons_ratio", {0.3}}, {"restitution", {0.8}}, {"friction", {0.4}}};
  Scene s = scene(packing.dimension, 1e-3, agitated_bodies(packing.dimension), law, packing.law);
  add_enclosure(s, packing);
  for (const double k : packing.periodic)
    for (Body& b : s.bodies)
      if (!packing.groups) b.velocity[int(k)] += 4;
  std::vector<double> gravity = {0.1, 0.2, -1};
  if (packing.dimension == 2) gravity = {0.1, -1, 0};
  add_body_force(s, "gravity", {{"acceleration", gravity}});
  if (packing.damping > 0) add_body_force(s, "background_damping", {{"translational", {packing.damping}}});
  if (packing.groups) add_groups(s);
  return s;
}

// After some steps, in which contacts begin, end and slide.
inline std::unique_ptr<Simulation> agitated(const PackingScene& packing, int steps = 150) {
  auto simulation = std::make_unique<Simulation>(scene_of(packing));
  run(*simulation, std::uint64_t(steps));
  return simulation;
}

// A grid over the whole scene and beyond its walls.
inline fields::FieldGrid grid_over(const PackingScene& packing, double spacing = 0.8) {
  fields::FieldGrid grid;
  grid.dimension = packing.dimension;
  for (int k = 0; k < packing.dimension; ++k) {
    const double length = cells_along(packing.dimension, k) * pitch;
    bool periodic = false;
    for (const double axis : packing.periodic) periodic |= int(axis) == k;
    const double outside = periodic ? 0 : 2 * pitch;
    const double count = std::round((length + 2 * outside) / spacing);
    grid.count[std::size_t(k)] = std::size_t(count);
    grid.spacing[k] = (length + 2 * outside) / count;
    grid.first[k] = -outside + 0.5 * grid.spacing[k];
    if (periodic) grid.period[k] = length;
  }
  return grid;
}

}  // namespace scree::test
