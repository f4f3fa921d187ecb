#include "scree/cycles/straight_line.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/median.hpp>

namespace scree::cycles {

namespace {

constexpr double most_pairs = 4e6;

void check(std::span<const double> values) {
  if (values.size() < 3)
    throw Error(fmt::format("a line through {} values has no deviations; give three or more", values.size()));
}

double rms_from(const StraightLine& line, std::span<const double> values, double first) {
  double squares = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double deviation = values[k] - (line.intercept + line.slope * (first + double(k)));
    squares += deviation * deviation;
  }
  return std::sqrt(squares / double(values.size()));
}

// The value that a share of the others is below.
double quantile(std::vector<double>& values, double share) {
  const auto place = values.begin() + std::ptrdiff_t(share * double(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

// Half the interval of Sen (1968) for one standard deviation: of the n(n − 1)/2 slopes as many lie on either side of the true one as pairs of n values in random
// order rise and fall, which is Kendall's number of variance n(n − 1)(2n + 5)/18.
double error_of_median(std::vector<double>& slopes, double n) {
  const double share = std::sqrt(n * (n - 1) * (2 * n + 5) / 18) / (n * (n - 1));
  return 0.5 * (quantile(slopes, 0.5 + share) - quantile(slopes, 0.5 - share));
}

}  // namespace

StraightLine fit_line(std::span<const double> values, double first) {
  check(values);
  const double n = double(values.size()), middle = (n - 1) / 2;
  // Relative to the first value, so that a small change of a large value keeps its digits.
  double sum = 0, moment = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    sum += values[k] - values[0];
    moment += (double(k) - middle) * (values[k] - values[0]);
  }
  StraightLine line;
  line.slope = moment * 12 / (n * (n * n - 1));
  line.intercept = values[0] + sum / n - line.slope * (first + middle);
  line.rms = rms_from(line, values, first);
  line.slope_error = line.rms * std::sqrt(12 / ((n - 2) * (n * n - 1)));
  return line;
}

StraightLine robust_line(std::span<const double> values, double first) {
  check(values);
  const std::size_t n = values.size();
  const std::size_t stride = 1 + std::size_t(0.5 * double(n) * double(n) / most_pairs);
  std::vector<double> slopes, intercepts;
  for (std::size_t distance = 1; distance < n; distance += stride)
    for (std::size_t k = 0; k + distance < n; ++k)
      slopes.push_back((values[k + distance] - values[k]) / double(distance));
  StraightLine line;
  line.slope_error = error_of_median(slopes, double(n));
  line.slope = upper_median(std::move(slopes));
  for (std::size_t k = 0; k < n; ++k) intercepts.push_back(values[k] - line.slope * (first + double(k)));
  line.intercept = upper_median(std::move(intercepts));
  line.rms = rms_from(line, values, first);
  return line;
}

}  // namespace scree::cycles
