#include "reference.hpp"

#include "horizon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::accuracy {

Limit extrapolate(double at_h, double at_half, double at_quarter) {
  Limit best = {at_quarter, std::numeric_limits<double>::infinity()};
  for (const double gain : {2.0, 4.0}) {  // error reduction per halving of the step: first and second order
    const double once = at_half + (at_half - at_h) / (gain - 1);
    const double twice = at_quarter + (at_quarter - at_half) / (gain - 1);
    if (std::abs(twice - once) < best.uncertainty) best = {twice, std::abs(twice - once)};
  }
  return best;
}

namespace {

Quantity quantity_of(const scenario::Expectation& e, const std::vector<run::InMemoryRun>& runs, std::size_t k,
                     bool cut) {
  const double scale = e.scale.value_or(0);
  // No relative error is possible for a reference of 0 without a scale.
  if (e.reference && *e.reference == 0 && scale == 0 && cut) return {e.quantity, 0, INFINITY, 0, false};
  if (e.reference && !e.of_step && !cut) return {e.quantity, *e.reference, 0, scale, true};
  const bool bound = !e.reference && e.quantity == "energy_created";  // only rounding
  if (bound || e.quantity == "energy_residual" || e.quantity == "momentum_residual")
    return {e.quantity, 0, 0, 1, true};
  const Limit limit = extrapolate(runs[0].quantities[k], runs[1].quantities[k], runs[2].quantities[k]);
  return {e.quantity, limit.value, limit.uncertainty, scale, false};
}

}  // namespace

std::vector<std::size_t> compared_expectations(const scenario::Plan& plan,
                                               const std::vector<run::InMemoryRun>& runs,
                                               std::vector<std::string>& without) {
  static const std::vector<std::string> of_the_run = {"steps", "time", "neighbour_searches",
                                                      "min_steps_per_contact"};
  std::vector<std::size_t> compared;
  for (std::size_t k = 0; k < plan.expectations.size(); ++k) {
    const std::string& name = plan.expectations[k].quantity;
    if (std::find(of_the_run.begin(), of_the_run.end(), name) != of_the_run.end()) continue;
    const bool known = std::all_of(runs.begin(), runs.end(),
                                   [k](const run::InMemoryRun& t) { return std::isfinite(t.quantities[k]); });
    if (known)
      compared.push_back(k);
    else
      without.push_back(name);
  }
  return compared;
}

std::vector<Quantity> reference_quantities(const scenario::Plan& plan,
                                           const std::vector<run::InMemoryRun>& runs,
                                           const std::vector<std::size_t>& compared, bool cut) {
  std::vector<Quantity> quantities;
  for (const std::size_t k : compared) quantities.push_back(quantity_of(plan.expectations[k], runs, k, cut));
  return quantities;
}

ReferencePositions reference_positions(const std::vector<run::InMemoryRun>& runs) {
  ReferencePositions reference = {runs.back().positions, 0};
  double square = 0;
  for (std::size_t i = 0; i < reference.positions.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const Limit limit =
          extrapolate(runs[0].positions[i][k], runs[1].positions[i][k], runs[2].positions[i][k]);
      reference.positions[i][k] = limit.value;
      square += limit.uncertainty * limit.uncertainty;
    }
  if (square > 0) reference.uncertainty = std::sqrt(square / double(reference.positions.size()));
  return reference;
}

double mean_radius(const scenario::Plan& plan) {
  double sum = 0;
  for (const Body& body : plan.scene.bodies) sum += body.radius;
  return plan.scene.bodies.empty() ? 1 : sum / double(plan.scene.bodies.size());
}

}  // namespace scree::accuracy
