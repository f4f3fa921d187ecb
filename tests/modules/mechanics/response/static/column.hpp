#pragma once

#include "scenes.hpp"

#include <vector>

namespace scree::test {

inline constexpr int column_discs = 3;
inline constexpr double disc_stiffness = 1000;  // (N/m)

// Smooth discs of radius 1 in a column that just touches a floor and an upper wall. control: of the upper
// wall, -1: fixed.
inline Scene column(int control) {
  constexpr double overlap = 1e-12, d = 2 - overlap;
  std::vector<Body> bodies;
  for (int n = 0; n < column_discs; ++n) bodies.push_back(body(n, 1, 1, {{0, d * (n + 0.5), 0}}, {}, {}, 2));
  Scene scene = test::scene(2, 1e-4, std::move(bodies),
                            {{"normal_stiffness", {disc_stiffness}}, {"normal_damping", {0}}});
  add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}}, "floor");
  Values top = {{"point", {0, d * column_discs, 0}}, {"normal", {0, -1, 0}}};
  if (control >= 0)
    top.insert(
        top.end(),
        {{"direction", {0, -1, 0}}, {"control", {double(control)}}, {"force", {0, 1}}, {"speed_limit", {1}}});
  add_boundary(scene, "plane", top, "top");
  return scene;
}

}  // namespace scree::test
