#include "orders.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::accuracy {

namespace {

// Errors below ten times the uncertainty of the reference, or the round-off over a run, are not significant;
// errors above a tenth are saturated.
constexpr double safety = 10, ceiling = 0.1;
double floor_of(const Quantity& q) {
  constexpr double round_off = 1e-14;
  return safety * std::max(q.uncertainty / q.scale(), round_off);
}

// The errors of an integrator from the coarsest step on: of a quantity, or the largest; `shown` of an
// outcome's error in a quantity.
template <class Shown>
std::vector<double> errors_of(const Convergence& study, Integration integration,
                              std::optional<std::size_t> quantity, std::vector<double>& steps,
                              const Shown& shown) {
  std::vector<double> errors;
  steps.clear();
  for (const SettingResult& o : study.outcomes) {
    if (o.setting.integration != integration) continue;
    const double error = shown(o, quantity.value_or(o.problem.empty() ? o.worst_quantity() : 0));
    if (std::isnan(error)) continue;
    steps.push_back(o.setting.step);
    errors.push_back(error);
  }
  return errors;
}

Order order_of(const Convergence& study, Integration integration) {
  // Errors below the floor count as 0.
  const auto usable = [&](const SettingResult& o, std::size_t k) {
    if (!o.problem.empty()) return std::numeric_limits<double>::quiet_NaN();
    return o.errors[k] > floor_of(study.quantities[k]) ? o.errors[k] : 0;
  };
  const auto of = [&](std::optional<std::size_t> quantity) {
    std::vector<double> steps;
    const std::vector<double> errors = errors_of(study, integration, quantity, steps, usable);
    return fitted_order(steps, errors, ceiling);
  };
  Order order = {integration, of(std::nullopt), {}};
  for (std::size_t k = 0; k < study.quantities.size(); ++k) order.of_quantities.push_back(of(k));
  return order;
}

LongestStep longest_step_of(const Convergence& study, Integration integration) {
  // A step without results is too long.
  const auto error = [](const SettingResult& o, std::size_t k) {
    return o.problem.empty() ? o.errors[k] : std::numeric_limits<double>::infinity();
  };
  const auto of = [&](std::optional<std::size_t> quantity) {
    std::vector<double> steps;
    const std::vector<double> errors = errors_of(study, integration, quantity, steps, error);
    return longest_step(steps, errors, study.tolerance);
  };
  LongestStep longest = {integration, of(std::nullopt), {}};
  for (std::size_t k = 0; k < study.quantities.size(); ++k) longest.of_quantities.push_back(of(k));
  return longest;
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

std::optional<double> longest_step(const std::vector<double>& steps, const std::vector<double>& errors,
                                   double tolerance) {
  std::size_t first = steps.size();
  while (first > 0 && errors[first - 1] <= tolerance) --first;
  if (first == steps.size()) return std::nullopt;
  if (first == 0 || !std::isfinite(errors[first - 1]) || !(errors[first] > 0)) return steps[first];
  const double order =
      std::log(errors[first - 1] / errors[first]) / std::log(steps[first - 1] / steps[first]);
  return steps[first] * std::pow(tolerance / errors[first], 1 / order);
}

void summarise_methods(Convergence& study) {
  for (const SettingResult& o : study.outcomes) {
    if (std::any_of(study.orders.begin(), study.orders.end(),
                    [&](const Order& order) { return order.integration == o.setting.integration; }))
      continue;
    study.orders.push_back(order_of(study, o.setting.integration));
    study.longest_steps.push_back(longest_step_of(study, o.setting.integration));
  }
}

}  // namespace scree::accuracy
