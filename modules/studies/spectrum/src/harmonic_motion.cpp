#include "harmonic_motion.hpp"

namespace scree::spectrum {

namespace {

// Up to here a factorisation at each frequency takes less than a second for hundreds of them, and is exact.
constexpr Eigen::Index few_degrees_of_freedom = 300;

}  // namespace

HarmonicMotion harmonic_motion(const Simulation& simulation, const std::vector<Vec3>& walls,
                               const std::vector<double>& frequencies_hz,
                               const response::AssemblyOptions& options, const response::BandOptions& band) {
  const response::LinearSystem system = response::assemble(simulation, options);
  response::Drive drive;
  drive.walls = Eigen::VectorXcd::Zero(system.wall_stiffness.cols());
  const int dimension = simulation.dimension();
  for (std::size_t w = 0; w < walls.size(); ++w)
    for (int k = 0; k < dimension; ++k) drive.walls[Eigen::Index(w) * dimension + k] = walls[w][k];
  if (system.freedom.size() <= few_degrees_of_freedom)
    return {system.freedom, system.sliding_contacts, system.one_way_contacts, system.time_step,
            response::solve(system, drive, frequencies_hz, band.stop)};
  return {system.freedom, system.sliding_contacts, system.one_way_contacts, system.time_step,
          response::solve_band(system, drive, frequencies_hz, band).responses};
}

}  // namespace scree::spectrum
