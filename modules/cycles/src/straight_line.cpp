#include "scree/cycles/straight_line.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/spectrum/median.hpp>

namespace scree::cycles {

namespace {

constexpr double most_pairs = 4e6;

void check(std::span<const double> values) {
  if (values.size() < 3)
    throw Error(fmt::format("a line through {} values has no deviations; give three or more", values.size()));
}

void set_deviations(StraightLine& line, std::span<const double> values, double first) {
  const double n = double(values.size());
  double squares = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double deviation = values[k] - (line.intercept + line.slope * (first + double(k)));
    squares += deviation * deviation;
  }
  line.rms = std::sqrt(squares / n);
  line.slope_error = std::sqrt(squares / (n - 2) * 12 / (n * (n * n - 1)));
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
  set_deviations(line, values, first);
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
  line.slope = spectrum::median(std::move(slopes));
  for (std::size_t k = 0; k < n; ++k) intercepts.push_back(values[k] - line.slope * (first + double(k)));
  line.intercept = spectrum::median(std::move(intercepts));
  set_deviations(line, values, first);
  return line;
}

}  // namespace scree::cycles
