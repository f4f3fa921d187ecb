#pragma once

#include "scenes.hpp"

#include <utility>
#include <vector>

#include <scree/response/linear_system.hpp>

namespace scree::test {

inline constexpr double stiffness = 1000, damping = 2, mass = 0.3;
inline constexpr int beads = 20;

// A row of beads along x between a wall and nothing, without a stress that would turn it over.
inline response::LinearSystem chain() {
  const double overlap = 1e-12;
  std::vector<Body> bodies;
  for (int n = 0; n < beads; ++n)
    bodies.push_back(body(n, 1, mass, {{1 - overlap + (2 - overlap) * n, 0, 0}}, {}, {}, 2));
  Scene scene = test::scene(2, 1e-4, std::move(bodies),
                            {{"normal_stiffness", {stiffness}}, {"normal_damping", {damping}}});
  add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {1, 0, 0}}}, "wall");
  return response::assemble(Simulation(scene), {.fewest_contacts = 1});
}

}  // namespace scree::test
