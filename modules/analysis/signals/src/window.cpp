#include "window.hpp"

#include <cmath>
#include <numbers>

namespace scree::signals {

std::vector<double> hann(std::size_t count) {
  std::vector<double> window(count);
  for (std::size_t j = 0; j < count; ++j)
    window[j] = std::pow(std::sin(std::numbers::pi * double(j) / double(count)), 2);
  return window;
}

void remove_line(std::span<double> values) {
  const double count = double(values.size()), middle = 0.5 * (count - 1);
  double mean = 0, slope = 0;
  for (const double x : values) mean += x / count;
  for (std::size_t j = 0; j < values.size(); ++j) slope += (double(j) - middle) * (values[j] - mean);
  const double square = count * (count * count - 1) / 12;
  for (std::size_t j = 0; j < values.size(); ++j)
    values[j] -= mean + (square > 0 ? slope / square * (double(j) - middle) : 0);
}

}  // namespace scree::signals
