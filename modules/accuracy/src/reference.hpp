#pragma once

#include <vector>

#include <scree/accuracy/study.hpp>
#include <scree/run/trial.hpp>

namespace scree::accuracy {

// The limit of values at steps h, h/2, h/4 (Richardson), of the first or the second order, whichever agrees
// better with itself; and by how much the last refinement changed it.
struct Limit {
  double value, uncertainty;
};
Limit extrapolate(double at_h, double at_half, double at_quarter);

// Which expectations of a plan compare: all but those that tell how the run was made, such as its number of
// steps, and those that have no number in the trials, whose names go to `without`.
std::vector<std::size_t> compared_expectations(const scenario::Plan& plan,
                                               const std::vector<run::Trial>& trials,
                                               std::vector<std::string>& without);

// What the trials of a plan with the steps h, h/2, h/4 say of its expectations: closed forms where they name
// them for the whole run, 0 for residuals, else the limit. The last quantity is "positions".
std::vector<Quantity> reference_quantities(const scenario::Plan& plan, const std::vector<run::Trial>& trials,
                                           const std::vector<std::size_t>& compared, bool cut);
// The limit of the bodies' positions and its root mean square uncertainty (m).
struct ReferencePositions {
  std::vector<Vec3> positions;
  double uncertainty;
};
ReferencePositions reference_positions(const std::vector<run::Trial>& trials);

double mean_radius(const scenario::Plan& plan);

}  // namespace scree::accuracy
