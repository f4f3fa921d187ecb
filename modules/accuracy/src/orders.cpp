#include "orders.hpp"

#include <algorithm>
#include <cmath>

namespace scree::accuracy {

namespace {

// Errors below ten times the uncertainty of the reference, or the round-off over a run, are not significant;
// errors above a tenth are saturated.
constexpr double safety = 10, ceiling = 0.1;
double floor_of(const Quantity& q, Precision precision) {
  const double round_off = precision == Precision::mixed ? 1e-7 : 1e-14;
  return safety * std::max(q.uncertainty / q.scale(), round_off);
}

bool same_method(const Setting& a, const Setting& b) {
  return a.integration == b.integration && a.precision == b.precision;
}

Order order_of(const Study& study, const Setting& method) {
  // Errors below the floor count as 0.
  const auto usable = [&](const Outcome& o, std::size_t k) {
    return o.errors[k] > floor_of(study.quantities[k], method.precision) ? o.errors[k] : 0;
  };
  std::vector<double> steps, worst, positions;
  for (const Outcome& o : study.outcomes) {
    if (!same_method(o.setting, method) || !o.problem.empty()) continue;
    steps.push_back(o.setting.step);
    worst.push_back(usable(o, o.worst_quantity()));
    positions.push_back(usable(o, study.quantities.size() - 1));
  }
  return {{method.integration, method.precision, 0},
          fitted_order(steps, worst, ceiling),
          fitted_order(steps, positions, ceiling)};
}

// Halving the step must reduce the error by at least this factor; otherwise other errors dominate.
constexpr double min_gain = 1.4;

}  // namespace

namespace {

// The longest range of points [first, last) with usable, decreasing errors.
std::pair<std::size_t, std::size_t> falling_run(const std::vector<double>& errors, double top) {
  std::pair<std::size_t, std::size_t> longest = {0, 0};
  for (std::size_t first = 0, k = 0; k < errors.size(); ++k) {
    const bool usable = errors[k] > 0 && errors[k] < top;
    if (k > 0 && errors[k] * min_gain > errors[k - 1]) first = k;
    if (!usable) first = k + 1;
    if (k + 1 - first > longest.second - longest.first && first <= k) longest = {first, k + 1};
  }
  return longest;
}

}  // namespace

std::optional<double> fitted_order(const std::vector<double>& steps, const std::vector<double>& errors,
                                   double top) {
  const auto [first, last] = falling_run(errors, top);
  if (last - first < 3) return std::nullopt;
  const double n = double(last - first);
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t k = first; k < last; ++k) {
    const double u = std::log(steps[k]), v = std::log(errors[k]);
    x += u, y += v, xx += u * u, xy += u * v;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

std::vector<Order> fit_orders(const Study& study) {
  std::vector<Order> orders;
  for (const Outcome& o : study.outcomes) {
    const bool known = std::any_of(orders.begin(), orders.end(),
                                   [&](const Order& order) { return same_method(order.method, o.setting); });
    if (!known) orders.push_back(order_of(study, o.setting));
  }
  return orders;
}

}  // namespace scree::accuracy
