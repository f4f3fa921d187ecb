#include "reference.hpp"

#include "horizon.hpp"

#include <algorithm>
#include <cmath>

namespace scree::accuracy {

Limit extrapolate(double at_h, double at_half, double at_quarter) {
  constexpr double least_order = 1, most_order = 4;
  const double first = at_half - at_h, second = at_quarter - at_half;
  if (second == 0) return {at_quarter, 0};
  const double ratio = std::clamp(std::abs(first / second), std::exp2(least_order), std::exp2(most_order));
  const double correction = second / (ratio - 1);
  return {at_quarter + correction, std::abs(correction)};
}

namespace {

Quantity quantity_of(const scenario::Expectation& e, const std::vector<scenario::Trial>& trials,
                     std::size_t k) {
  if (e.reference) return {e.quantity, *e.reference, 0, true};
  if (e.quantity == "energy_residual" || e.quantity == "momentum_residual") return {e.quantity, 0, 0, true};
  const Limit limit = extrapolate(trials[0].quantities[k], trials[1].quantities[k], trials[2].quantities[k]);
  return {e.quantity, limit.value, limit.uncertainty, false};
}

}  // namespace

std::vector<Quantity> reference_quantities(const scenario::Plan& plan,
                                           const std::vector<scenario::Trial>& trials) {
  std::vector<Quantity> quantities;
  for (std::size_t k = 0; k < plan.expectations.size(); ++k)
    quantities.push_back(quantity_of(plan.expectations[k], trials, k));
  const double uncertainty =
      distance_between(reference_positions(trials), trials.back().positions) / mean_radius(plan);
  quantities.push_back({"positions", 0, uncertainty, false});
  return quantities;
}

std::vector<Vec3> reference_positions(const std::vector<scenario::Trial>& trials) {
  std::vector<Vec3> limit = trials.back().positions;
  for (std::size_t i = 0; i < limit.size(); ++i)
    for (int k = 0; k < 3; ++k)
      limit[i][k] =
          extrapolate(trials[0].positions[i][k], trials[1].positions[i][k], trials[2].positions[i][k]).value;
  return limit;
}

double mean_radius(const scenario::Plan& plan) {
  double sum = 0;
  for (const Body& body : plan.scene.bodies) sum += body.radius;
  return plan.scene.bodies.empty() ? 1 : sum / double(plan.scene.bodies.size());
}

}  // namespace scree::accuracy
