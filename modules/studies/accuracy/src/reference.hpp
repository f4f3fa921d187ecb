#pragma once

#include <vector>

#include <scree/accuracy/study.hpp>
#include <scree/run/run_in_memory.hpp>

namespace scree::accuracy {

// Richardson extrapolation of values at steps h, h/2, h/4, of first or second order, whichever is more
// consistent. uncertainty: change by the last refinement.
struct Limit {
  double value, uncertainty;
};
Limit extrapolate(double at_h, double at_half, double at_quarter);

// Indices of the expectations that are compared: all except properties of the run itself, such as its number
// of steps, and those without a value in the runs, whose names are added to `without`.
std::vector<std::size_t> compared_expectations(const scenario::Plan& plan,
                                               const std::vector<run::InMemoryRun>& runs,
                                               std::vector<std::string>& without);

// References from runs with the steps h, h/2, h/4: closed forms of expectations if valid for the whole run,
// 0 for residuals, else the extrapolated limit.
std::vector<Quantity> reference_quantities(const scenario::Plan& plan,
                                           const std::vector<run::InMemoryRun>& runs,
                                           const std::vector<std::size_t>& compared, bool cut);
// Extrapolated positions of the bodies and their root mean square uncertainty (m).
struct ReferencePositions {
  std::vector<Vec3> positions;
  double uncertainty;
};
ReferencePositions reference_positions(const std::vector<run::InMemoryRun>& runs);

double mean_radius(const scenario::Plan& plan);

}  // namespace scree::accuracy
