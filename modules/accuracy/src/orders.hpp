#pragma once

#include <scree/accuracy/study.hpp>

namespace scree::accuracy {

// Slope of log(error) over log(step), for decreasing steps, through the longest range of points with
// decreasing errors between 0 and `top`; empty with fewer than three points.
std::optional<double> fitted_order(const std::vector<double>& steps, const std::vector<double>& errors,
                                   double top);

// One order per method, in the order of the outcomes.
std::vector<Order> fit_orders(const Study& study);

}  // namespace scree::accuracy
