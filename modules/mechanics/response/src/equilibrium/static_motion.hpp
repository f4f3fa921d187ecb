#pragma once

#include <vector>

#include <Eigen/Core>

#include <scree/response/degrees_of_freedom.hpp>
#include <scree/simulation.hpp>

namespace scree::response {

// A small motion of all bodies and, behind them, of all walls, which do not rotate.
struct StaticMotion {
  std::vector<Vec3> displacement, rotation;  // (m), (rad)

  StaticMotion(const Eigen::VectorXd& q, const DegreesOfFreedom& freedom, const WallEquations& walls);
};

}  // namespace scree::response
