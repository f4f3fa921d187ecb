#pragma once

#include <scree/accuracy/study.hpp>

namespace scree::accuracy {

// Slope of log(error) over log(step), for decreasing steps, through the longest range of points with
// decreasing errors between 0 and `top`; empty with fewer than three points.
std::optional<double> fitted_order(const std::vector<double>& steps, const std::vector<double>& errors,
                                   double top);

// The step, for decreasing steps, with which the error and those of all shorter ones are within the
// tolerance; between two steps as their errors have it. Empty if there is none.
std::optional<double> longest_step(const std::vector<double>& steps, const std::vector<double>& errors,
                                   double tolerance);

// Sets orders and longest steps, one per method in the order of the outcomes.
void summarise_methods(Convergence& study);

}  // namespace scree::accuracy
