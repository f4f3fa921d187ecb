#include <cmath>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/cycles/straight_line.hpp>

using scree::cycles::fit_line;
using scree::cycles::robust_line;
using scree::cycles::StraightLine;

namespace {

// Mean squares of the error of a slope and of its stated error.
struct Errors {
  double scatter = 0, stated = 0;
};

// From 400 lines of slope 3 through 72 values with normal noise, and 1000 added to a share of the values.
template <class Line>
Errors errors_of(const Line& line_of, double share) {
  Errors errors;
  for (unsigned seed = 1; seed <= 400; ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::bernoulli_distribution off(share);
    std::vector<double> values;
    for (int n = 0; n < 72; ++n) values.push_back(3 * n + normal(random) + (off(random) ? 1000 : 0));
    const StraightLine line = line_of(values);
    errors.scatter += (line.slope - 3) * (line.slope - 3) / 400;
    errors.stated += line.slope_error * line.slope_error / 400;
  }
  return errors;
}

// Three times the scatter of a variance from 400 values, sqrt(2/400) = 7 %.
constexpr double scatter_of_400 = 0.21;

}  // namespace

TEST_CASE("the standard error of a slope is that of its scatter", "[straight_line]") {
  const Errors errors = errors_of([](const auto& values) { return fit_line(values); }, 0);
  CHECK(errors.scatter == Approx(errors.stated).epsilon(scatter_of_400));
}

TEST_CASE("the standard error of a median slope is that of its scatter, also beside outliers",
          "[straight_line]") {
  for (const double share : {0.0, 0.1}) {
    const Errors errors = errors_of([](const auto& values) { return robust_line(values); }, share);
    CHECK(errors.scatter == Approx(errors.stated).epsilon(scatter_of_400));
  }
}

TEST_CASE("the median line of many values is that of some of their pairs", "[straight_line]") {
  std::vector<double> values;
  for (int n = 0; n < 6000; ++n) values.push_back(n % 5 == 0 ? 1e6 : 3 - 2 * n);
  const StraightLine line = robust_line(values, 10);
  CHECK(line.slope == -2);
  CHECK(line.intercept == 23);
}
