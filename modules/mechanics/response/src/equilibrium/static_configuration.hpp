#pragma once

#include <vector>

#include <Eigen/Core>

#include <scree/orientations.hpp>
#include <scree/response/degrees_of_freedom.hpp>
#include <scree/simulation.hpp>

namespace scree::response {

// A small motion of all bodies, then of all walls, which do not rotate.
struct StaticMotion {
  std::vector<Vec3> displacement, rotation;  // (m), (rad)

  StaticMotion(const Eigen::VectorXd& q, const DegreesOfFreedom& freedom, const WallEquations& walls);
};

// The places of the bodies, then of the walls.
struct StaticConfiguration {
  std::vector<Vec3> position;  // (m) centres without jumps at periodic faces; points of planes and surfaces
  Orientations orientations;   // if a law reads them

  explicit StaticConfiguration(const Simulation& simulation);
  // The simulation's planes moved to this configuration, with zero velocity.
  std::vector<scree_plane> planes(const Simulation& simulation) const;
  // The same of its surfaces.
  std::vector<scree_frame> frames(const Simulation& simulation) const;
  void move(const StaticMotion& motion);
};

}  // namespace scree::response
