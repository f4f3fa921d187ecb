#pragma once

#include "scenes.hpp"

#include <vector>

// Beads in a row along x, pressed together, with normal springs and dashpots.

namespace scree::test {

inline constexpr double bead_stiffness = 1000, bead_damping = 2, bead_mass = 0.3, bead_overlap = 1e-3;
inline constexpr int bead_count = 20;

// first: position of the first (m).
inline std::vector<Body> beads_from(double first) {
  std::vector<Body> bodies;
  for (int n = 0; n < bead_count; ++n)
    bodies.push_back(body(n, 1, bead_mass, {{first + (2 - bead_overlap) * n, 0, 0}}, {}, {}, 2));
  return bodies;
}

}  // namespace scree::test
