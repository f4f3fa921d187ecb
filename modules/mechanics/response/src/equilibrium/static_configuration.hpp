#pragma once

#include "equilibrium/static_motion.hpp"

#include <vector>

#include <scree/orientations.hpp>
#include <scree/simulation.hpp>

namespace scree::response {

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
