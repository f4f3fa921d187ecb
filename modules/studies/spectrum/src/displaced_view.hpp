#pragma once

#include "harmonic_motion.hpp"

#include <array>
#include <complex>
#include <vector>

#include <scree/probes.hpp>
#include <scree/response/harmonic_rates.hpp>
#include <scree/wall_equations.hpp>

namespace scree::spectrum {

// A view of a simulation whose bodies and walls are displaced by a share of a harmonic motion, at the phase 0 or
// −π/2 of e^(iωt): by the real or the imaginary part of their amplitudes. Contacts, forces, lengths and spins do not
// change.
class DisplacedView {
 public:
  enum class Part { real, imaginary };

  // time_step: (s) of velocity Verlet, by which velocities are output; 0: continuous time.
  DisplacedView(const Simulation& simulation, const std::vector<Vec3>& walls,
                const response::DegreesOfFreedom& freedom, double time_step);

  const scree_view& at_rest() const { return rest_.get(); }
  // Valid until the next call.
  const scree_view& displaced(const response::HarmonicResponse& motion, Part part, double share);

 private:
  using Complex = std::complex<double>;
  // turn: the share with its phase; both displacement and velocity are real parts of what it gives.
  void displace_bodies(const response::HarmonicResponse& motion, Complex turn, Complex to_velocity);
  void displace_walls(const response::HarmonicResponse& motion, Complex turn,
                      const response::HarmonicRates& rates);

  const Simulation& simulation_;
  const std::vector<Vec3>& walls_;
  const response::DegreesOfFreedom& freedom_;
  SimulationView rest_;
  scree_view view_;
  std::array<std::vector<double>, 3> position_, velocity_;
  WallEquations equations_;
  double time_step_;
  std::vector<scree_plane> planes_;
};

}  // namespace scree::spectrum
