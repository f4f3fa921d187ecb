#pragma once

#include "displaced_view.hpp"
#include "observer.hpp"

#include <complex>
#include <string>
#include <utility>
#include <vector>

#include <scree/response/frequency_response.hpp>

namespace scree::spectrum {

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
  double smallest_ = 0;     // (m) radius
  Eigen::VectorXd radius_;  // (m) of the bodies whose rotations are degrees of freedom, and 1 elsewhere
};

// Whether the columns of a probe may follow from positions and velocities of bodies and walls alone.
bool is_of_motion(const scenario::ProbePlan& probe, int dimension);

// Columns of all probes of the plan that change along a motion. walls: displacement of each wall (m).
std::vector<std::string> responding_columns(const scenario::Plan& plan, const Simulation& simulation,
                                            const std::vector<Vec3>& walls,
                                            const response::DegreesOfFreedom& freedom,
                                            const response::HarmonicResponse& motion);

}  // namespace scree::spectrum
