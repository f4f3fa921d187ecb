#include "orders.hpp"

#include <algorithm>
#include <cmath>

namespace scree::accuracy {

namespace {

// Errors below ten times what is known of the reference, or of round-off over a run, tell nothing; those
// above a tenth have saturated.
constexpr double safety = 10, ceiling = 0.1;
double floor_of(const Quantity& q, Precision precision) {
  const double round_off = precision == Precision::mixed ? 1e-7 : 1e-14;
  return safety * std::max(q.uncertainty / q.scale(), round_off);
}

bool same_method(const Setting& a, const Setting& b) {
  return a.integration == b.integration && a.precision == b.precision;
}

Order order_of(const Study& study, const Setting& method) {
  std::vector<double> steps, worst, positions;
  double floor = 0;
  for (const Outcome& o : study.outcomes) {
    if (!same_method(o.setting, method) || !o.problem.empty()) continue;
    steps.push_back(o.setting.step);
    worst.push_back(o.worst());
    positions.push_back(o.errors.back());
    floor = std::max(floor, floor_of(study.quantities[o.worst_quantity()], method.precision));
  }
  return {{method.integration, method.precision, 0},
          fitted_order(steps, worst, floor, ceiling),
          fitted_order(steps, positions, floor_of(study.quantities.back(), method.precision), ceiling)};
}

}  // namespace

std::optional<double> fitted_order(const std::vector<double>& steps, const std::vector<double>& errors,
                                   double floor, double ceiling_) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (!(errors[k] > floor && errors[k] < ceiling_)) continue;
    const double u = std::log(steps[k]), v = std::log(errors[k]);
    n += 1, x += u, y += v, xx += u * u, xy += u * v;
  }
  if (n < 3) return std::nullopt;
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
