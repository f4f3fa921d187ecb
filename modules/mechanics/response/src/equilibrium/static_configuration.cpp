#include "equilibrium/static_configuration.hpp"

#include <algorithm>

#include <scree/wall_surfaces.hpp>

namespace scree::response {

StaticMotion::StaticMotion(const Eigen::VectorXd& q, const DegreesOfFreedom& freedom,
                           const WallEquations& walls)
    : displacement(freedom.bodies() + freedom.walls()), rotation(displacement.size()) {
  const int D = freedom.dimension(), S = freedom.spins();
  for (std::size_t i = 0; i < freedom.bodies(); ++i) {
    const auto moved = [&](Eigen::Index number) { return number == DegreesOfFreedom::none ? 0 : q[number]; };
    for (int k = 0; k < D; ++k) displacement[i][k] = moved(freedom.translation(i, k));
    for (int k = 0; k < S; ++k) rotation[i][D == 2 ? 2 : k] = moved(freedom.rotation(i, k));
  }
  for (std::size_t w = 0; w < freedom.walls(); ++w) {
    if (freedom.wall(w) == DegreesOfFreedom::none) continue;
    for (int k = 0; k < D; ++k)
      displacement[freedom.bodies() + w][k] = q[freedom.wall(w)] * walls.walls[w].direction[k];
  }
}

StaticConfiguration::StaticConfiguration(const Simulation& simulation)
    : orientations(simulation.particles().orientations) {
  const Particles& p = simulation.particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    Vec3 x = {};
    for (int k = 0; k < p.dimension(); ++k) {
      x[k] = p.position()[k][i];
      if (!p.image[k].empty()) x[k] += p.image[k][i] * simulation.domain().length(k);
    }
    position.push_back(x);
  }
  for (const scree_plane& plane : simulation.planes()) {
    Vec3 x = {};
    for (int k = 0; k < p.dimension(); ++k) x[k] = plane.point[k];
    position.push_back(x);
  }
  for (const scree_frame& frame : simulation.surfaces().frames)
    position.push_back({{frame.position[0], frame.position[1], frame.position[2]}});
}

std::vector<scree_plane> StaticConfiguration::planes(const Simulation& simulation) const {
  std::vector<scree_plane> all = simulation.planes();
  const std::size_t bodies = simulation.particles().size();
  for (std::size_t w = 0; w < all.size(); ++w)
    for (int k = 0; k < 3; ++k) {
      all[w].point[k] = position[bodies + w][k];
      all[w].velocity[k] = all[w].mid_velocity[k] = 0;
    }
  return all;
}

std::vector<scree_frame> StaticConfiguration::frames(const Simulation& simulation) const {
  std::vector<scree_frame> all = simulation.surfaces().frames;
  const std::size_t first = simulation.particles().size() + simulation.planes().size();
  for (std::size_t s = 0; s < all.size(); ++s) {
    scree_frame& frame = all[s];
    std::copy_n(position[first + s].component, 3, frame.position);
    for (int k = 0; k < 3; ++k)
      frame.velocity[k] = frame.mid_velocity[k] = frame.spin[k] = frame.mid_spin[k] = 0;
  }
  return all;
}

void StaticConfiguration::move(const StaticMotion& motion) {
  for (std::size_t i = 0; i < position.size(); ++i) position[i] += motion.displacement[i];
  if (orientations)
    orientations.rotate({motion.rotation[0].component, 3, motion.rotation.size(), 0, 3}, 1, 0,
                        orientations[0].size());
}

}  // namespace scree::response
