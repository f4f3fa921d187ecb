#pragma once

#include <scree/accuracy/study.hpp>

namespace scree::accuracy {

// Slope of log(error) over log(step) through the points above `floor` and below `ceiling`; nothing with fewer
// than three.
std::optional<double> fitted_order(const std::vector<double>& steps, const std::vector<double>& errors,
                                   double floor, double ceiling);

// One per method, in the order in which they were tried.
std::vector<Order> fit_orders(const Study& study);

}  // namespace scree::accuracy
