#pragma once

#include <scree/accuracy/study.hpp>

namespace scree::accuracy {

// Slope of log(error) over log(step), steps from the longest, through the longest run of points in which
// errors lie between 0 and `top` and fall; nothing with fewer than three.
std::optional<double> fitted_order(const std::vector<double>& steps, const std::vector<double>& errors,
                                   double top);

// One per method, in the order in which they were tried.
std::vector<Order> fit_orders(const Study& study);

}  // namespace scree::accuracy
