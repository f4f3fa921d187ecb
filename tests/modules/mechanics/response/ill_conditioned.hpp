#pragma once

#include "scenes.hpp"

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <scree/response/linear_system.hpp>

// Linear systems of discs whose stiffnesses or masses differ by many orders of magnitude.

namespace scree::test {

inline Scene::Law spring_law(const std::string& name, double normal, double tangential) {
  return {name, parameters("linear_spring_dashpot", SCREE_CONTACT_LAW,
                           {{"normal_stiffness", {normal}},
                            {"normal_damping", {0}},
                            {"tangential_stiffness", {tangential}},
                            {"static_friction", {50}}})};
}

// Discs near the places of a square lattice on a floor.
inline Scene wobbly_lattice(int side) {
  std::mt19937 engine(7);
  const auto wobble = [&engine] { return 2e-3 * (double(engine()) / 4294967295.0 - 0.5); };
  std::vector<Body> bodies;
  for (int n = 0; n < side * side; ++n) {
    const double x = wobble(), y = wobble();
    bodies.push_back(body(n, 1, 1 + 0.2 * std::cos(1.1 * n),
                          {{1.99 * (n % side) + x, 0.995 + 1.99 * (n / side) + y, 0}}, {}, {}, 2));
  }
  Scene scene =
      test::scene(2, 1e-4, std::move(bodies), {{"normal_stiffness", {1000}}, {"normal_damping", {0}}});
  add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}}, "floor");
  return scene;
}

// Only weak tangential springs, 1e-9 of the normal ones, keep columns and rows from sliding past each other.
inline response::LinearSystem nearly_floppy(int side) {
  Scene scene = wobbly_lattice(side);
  scene.laws = {spring_law("weak", 1000, 1e-6)};
  return response::assemble(Simulation(scene), {.fewest_contacts = 1});
}

// Contacts between bodies of different materials are a million times softer.
inline response::LinearSystem stiff_and_soft(int side) {
  Scene scene = wobbly_lattice(side);
  scene.materials = {"stiff", "soft"};
  scene.laws = {spring_law("stiff", 1e6, 5e5), spring_law("soft", 1, 0.5)};
  scene.law_of = {0, 1, 1, 0};
  std::mt19937 engine(3);
  for (Body& body : scene.bodies) body.material = std::uint32_t(engine() >> 31);
  return response::assemble(Simulation(scene), {.fewest_contacts = 1});
}

// Large discs in a row on a floor, each surrounded by a ring of discs 30 times smaller, of about 1/27000 of
// its mass. Without the differences of masses there would be many modes of the same frequency.
inline response::LinearSystem large_and_small(int large) {
  constexpr double ratio = 30;
  const double ring = ratio + 0.99, angle = 2 * std::asin(0.99 / ring);
  const int small = int(2 * M_PI / angle);
  std::vector<Body> bodies;
  std::int64_t id = 0;
  for (int n = 0; n < large; ++n) {
    const Vec3 centre = {{n * (2 * ratio + 3.97), ratio + 1.98, 0}};
    bodies.push_back(body(id++, ratio, ratio * ratio * ratio, centre, {}, {}, 2));
    for (int k = 0; k < small; ++k, ++id)
      bodies.push_back(body(id, 1, 1 + 0.2 * std::cos(1.1 * double(id)),
                            centre + Vec3{{ring * std::cos(k * angle), ring * std::sin(k * angle), 0}}, {},
                            {}, 2));
  }
  Scene scene =
      test::scene(2, 1e-4, std::move(bodies), {{"normal_stiffness", {1000}}, {"normal_damping", {0}}});
  scene.laws = {spring_law("springs", 1000, 700)};
  add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}}, "floor");
  return response::assemble(Simulation(scene), {.fewest_contacts = 1});
}

}  // namespace scree::test
