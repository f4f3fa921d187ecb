#include "orders.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::accuracy;

namespace {

const std::vector<double> halved_steps = {0.32, 0.16, 0.08, 0.04, 0.02, 0.01};

std::vector<double> errors_of(double order, double floor) {
  std::vector<double> errors;
  for (const double h : halved_steps) errors.push_back(0.5 * std::pow(h, order) + floor);
  return errors;
}

}  // namespace

TEST_CASE("the fitted order of a power is its exponent", "[accuracy]") {
  for (const double order : {1.0, 2.0, 4.0})
    CHECK(*fitted_order(halved_steps, errors_of(order, 0), 1) == Approx(order).epsilon(1e-12));
}

TEST_CASE("saturated points and points without decrease are excluded from the order", "[accuracy]") {
  std::vector<double> errors = errors_of(2, 0);
  errors[0] = errors[1] = 0.9;   // saturated
  errors[5] = 0.99 * errors[4];  // a floor
  CHECK(*fitted_order(halved_steps, errors, 0.1) == Approx(2).epsilon(1e-12));
  errors[3] = errors[2];
  CHECK_FALSE(fitted_order(halved_steps, errors, 0.1).has_value());
  CHECK_FALSE(fitted_order(halved_steps, std::vector<double>(6, 0.0), 0.1).has_value());
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
