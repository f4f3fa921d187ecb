#pragma once

#include <vector>

#include <Eigen/Core>

#include <scree/orientations.hpp>
#include <scree/response/degrees_of_freedom.hpp>
#include <scree/simulation.hpp>

namespace scree::response {

// A small motion of all bodies and, behind them, of all walls, which do not rotate.
struct StaticMotion {
  std::vector<Vec3> displacement, rotation;  // (m), (rad)

  StaticMotion(const Eigen::VectorXd& q, const DegreesOfFreedom& freedom, const WallEquations& walls);
};

// Where the bodies and, behind them, the walls are.
struct StaticConfiguration {
  std::vector<Vec3> position;  // (m) of bodies across periodic faces without jumps; points of walls
  Orientations orientations;   // if a law reads them

  explicit StaticConfiguration(const Simulation& simulation);
  // Those of the simulation where this configuration has them, at rest.
  std::vector<scree_plane> planes(const Simulation& simulation) const;
  void move(const StaticMotion& motion);
};

}  // namespace scree::response
