#include "orders.hpp"

#include "reference.hpp"
#include "steps.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::accuracy;

namespace {

const std::vector<double> steps = {0.32, 0.16, 0.08, 0.04, 0.02, 0.01};

std::vector<double> errors_of(double order, double floor) {
  std::vector<double> errors;
  for (const double h : steps) errors.push_back(0.5 * std::pow(h, order) + floor);
  return errors;
}

scenario::Plan plan_with_durations(const std::vector<double>& durations) {
  scenario::Plan plan;
  for (const double duration : durations) {
    Stage stage;
    stage.duration = duration;
    plan.stages.push_back(stage);
  }
  return plan;
}

}  // namespace

TEST_CASE("the fitted order of a power is its exponent", "[accuracy]") {
  for (const double order : {1.0, 2.0, 4.0})
    CHECK(*fitted_order(steps, errors_of(order, 0), 1) == Approx(order).epsilon(1e-12));
}

TEST_CASE("saturated points and points without decrease are excluded from the order", "[accuracy]") {
  std::vector<double> errors = errors_of(2, 0);
  errors[0] = errors[1] = 0.9;   // saturated
  errors[5] = 0.99 * errors[4];  // a floor
  CHECK(*fitted_order(steps, errors, 0.1) == Approx(2).epsilon(1e-12));
  errors[3] = errors[2];
  CHECK_FALSE(fitted_order(steps, errors, 0.1).has_value());
  CHECK_FALSE(fitted_order(steps, std::vector<double>(6, 0.0), 0.1).has_value());
}

TEST_CASE("extrapolation is exact for pure first and second order, and estimates its uncertainty",
          "[accuracy]") {
  for (const double order : {1.0, 2.0}) {
    const auto at = [&](double h) { return 3 + 0.7 * std::pow(h, order); };
    const Limit limit = extrapolate(at(0.4), at(0.2), at(0.1));
    CHECK(limit.value == Approx(3).epsilon(1e-14));
    CHECK(limit.uncertainty < 1e-14);
  }
  // Second order plus a fourth-order term: the remaining error is that of the fourth order, between h/2 and
  // h/4.
  const auto at = [](double h) { return 3 + 0.7 * h * h + 5 * std::pow(h, 4); };
  const Limit limit = extrapolate(at(0.4), at(0.2), at(0.1));
  CHECK(std::abs(limit.value - 3) <= limit.uncertainty);
  CHECK(limit.uncertainty < 20 * std::abs(limit.value - 3));
}

TEST_CASE("steps are adjusted to divide the durations of all stages", "[accuracy]") {
  CHECK(fitting_step(plan_with_durations({1}), 0.3) == Approx(0.25));
  CHECK(fitting_step(plan_with_durations({1}), 0.25) == 0.25);
  CHECK(fitting_step(plan_with_durations({0.5, 2}), 0.3) == Approx(0.25));
  CHECK(fitting_step(plan_with_durations({1, 1.1}), 0.3) == 0.3);  // no common divisor nearby
  CHECK(fitting_step(plan_with_durations({}), 0.3) == 0.3);
  CHECK(fitting_step(plan_with_durations({1}), 3) == 1);
}

TEST_CASE("the longest step within a tolerance lies between those tried, as their errors have it",
          "[accuracy]") {
  const std::vector<double> steps = {4, 2, 1};
  CHECK(*longest_step(steps, {0.16, 0.04, 0.01}, 0.09) == Approx(3));
  CHECK(*longest_step(steps, {0.16, 0.04, 0.01}, 0.2) == 4);
  CHECK(!longest_step(steps, {0.16, 0.04, 0.01}, 0.005));
  CHECK(*longest_step(steps, {INFINITY, 0.04, 0.01}, 0.09) == 2);
  // An error that happens to be small counts only if those of shorter steps are small too.
  CHECK(*longest_step(steps, {0.01, 0.04, 0.01}, 0.02) == Approx(std::sqrt(2)));
}
