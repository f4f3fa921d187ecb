#include "harmonic_motion.hpp"

namespace scree::sound {

HarmonicMotion harmonic_motion(const Simulation& simulation, const std::vector<Vec3>& walls,
                               const std::vector<double>& frequencies_hz,
                               const response::AssemblyOptions& options) {
  const response::LinearSystem system = response::assemble(simulation, options);
  response::Drive drive;
  drive.walls = Eigen::VectorXcd::Zero(system.wall_stiffness.cols());
  const int dimension = simulation.dimension();
  for (std::size_t w = 0; w < walls.size(); ++w)
    for (int k = 0; k < dimension; ++k) drive.walls[Eigen::Index(w) * dimension + k] = walls[w][k];
  return {system.freedom, response::solve(system, drive, frequencies_hz)};
}

}  // namespace scree::sound
