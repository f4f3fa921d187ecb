#pragma once

#include <cstddef>
#include <vector>

#include <scree/plugin/abi.h>

namespace scree {

// Equations of small motions of all walls, planes and then surfaces, about their present state, see
// scree_linear_wall.
struct WallEquations {
  std::vector<scree_linear_wall> walls;
  std::vector<double> stiffness;  // (walls, walls) (N/m) 0 between walls of different boundaries

  double stiffness_of(std::size_t pressed, std::size_t moved) const {
    return stiffness[pressed * walls.size() + moved];
  }
};

}  // namespace scree
