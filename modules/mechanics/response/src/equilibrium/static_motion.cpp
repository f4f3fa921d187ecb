#include "equilibrium/static_motion.hpp"

namespace scree::response {

StaticMotion::StaticMotion(const Eigen::VectorXd& q, const DegreesOfFreedom& freedom,
                           const WallEquations& walls)
    : displacement(freedom.bodies() + freedom.walls()), rotation(displacement.size()) {
  const int D = freedom.dimension(), S = freedom.spins();
  for (std::size_t i = 0; i < freedom.bodies(); ++i) {
    for (int k = 0; k < D; ++k) displacement[i][k] = q[freedom.translation(i, k)];
    for (int k = 0; k < S; ++k) rotation[i][D == 2 ? 2 : k] = q[freedom.rotation(i, k)];
  }
  for (std::size_t w = 0; w < freedom.walls(); ++w) {
    if (freedom.wall(w) == DegreesOfFreedom::none) continue;
    for (int k = 0; k < D; ++k)
      displacement[freedom.bodies() + w][k] = q[freedom.wall(w)] * walls.walls[w].direction[k];
  }
}

}  // namespace scree::response
