#pragma once

#include "observer.hpp"

#include <array>
#include <complex>
#include <string>
#include <utility>
#include <vector>

#include <scree/probes.hpp>
#include <scree/response/degrees_of_freedom.hpp>
#include <scree/response/frequency_response.hpp>
#include <scree/response/harmonic_rates.hpp>
#include <scree/simulation.hpp>
#include <scree/wall_equations.hpp>

namespace scree::spectrum {

// A view of a simulation whose bodies and walls are displaced by a share of a harmonic motion, at the phase 0
// or −π/2 of e^(iωt): by the real or the imaginary part of their amplitudes. Contacts, forces, lengths and
// spins do not change.
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
  // turn: complex factor of the amplitudes; displacements and velocities are the real parts of the products.
  void displace_bodies(const response::HarmonicResponse& motion, Complex turn, Complex to_velocity);
  void displace_walls(const response::HarmonicResponse& motion, Complex turn,
                      const response::HarmonicRates& rates);
  // After displace_walls().
  void turn_walls(const response::HarmonicResponse& motion, Complex turn,
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
  std::vector<scree_frame> frames_;
};

// Observed columns, linearised about the present state by central differences of their probes along a motion.
class LinearColumns {
 public:
  // walls: displacement of each wall (m). time_step: (s) by which velocities are output; 0: continuous time.
  LinearColumns(const scenario::Plan& plan, std::vector<ObservedColumn> observed,
                const Simulation& simulation, const std::vector<Vec3>& walls,
                const response::DegreesOfFreedom& freedom, double time_step);

  const std::vector<double>& at_rest() const { return rest_; }
  // Derivatives along a motion, and how much they change if the difference has half the size.
  std::pair<std::vector<std::complex<double>>, std::vector<double>> along(
      const response::HarmonicResponse& motion);

 private:
  std::vector<std::complex<double>> difference(const response::HarmonicResponse& motion, double share);

  Observer observer_;
  DisplacedView view_;
  std::vector<double> rest_;
  double smallest_ = 0;  // (m) radius
  // (m) by which angles that are degrees of freedom move surfaces; 1 elsewhere
  Eigen::VectorXd radius_;
};

// Whether the columns of a probe, by its number, may follow from positions and velocities of bodies and walls
// alone.
bool is_of_motion(const scenario::Plan& plan, std::size_t number);

// Columns of all probes of the plan that change along a motion. walls: displacement of each wall (m).
std::vector<std::string> responding_columns(const scenario::Plan& plan, const Simulation& simulation,
                                            const std::vector<Vec3>& walls,
                                            const response::DegreesOfFreedom& freedom,
                                            const response::HarmonicResponse& motion);

}  // namespace scree::spectrum
