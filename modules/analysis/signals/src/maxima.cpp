#include "maxima.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <scree/median.hpp>

namespace scree::signals {

namespace {

constexpr std::size_t half_window = 50, block = 25;
// A third difference of independent values has 20 times their variance.
constexpr double gain = 20;
// Median of the square of a normal deviate.
constexpr double median_of_square = 0.4549364;

// Of |H|^2 of third differences.
std::vector<double> third_differences(const Response& response) {
  std::vector<double> squares;
  const auto& h = response.values;
  for (std::size_t k = 0; k + 3 < h.size(); ++k)
    squares.push_back(std::norm(h[k + 3] - 3.0 * h[k + 2] + 3.0 * h[k + 1] - h[k]));
  return squares;
}

}  // namespace

std::vector<double> noise_of(const Response& response) {
  const std::vector<double> squares = third_differences(response);
  const double share = response.only_amplitudes ? median_of_square : std::numbers::ln2;
  double largest = 0;
  for (const auto& value : response.values) largest = std::max(largest, std::abs(value));
  std::vector<double> noise;
  while (noise.size() < response.values.size()) {
    const std::size_t middle = std::min(noise.size() + block / 2, squares.size() - 1);
    const std::size_t begin = middle > half_window ? middle - half_window : 0;
    const std::size_t end = std::min(squares.size(), middle + half_window + 1);
    const double square =
        upper_median({squares.begin() + std::ptrdiff_t(begin), squares.begin() + std::ptrdiff_t(end)}) /
        (gain * share);
    const std::size_t count = std::min(block, response.values.size() - noise.size());
    constexpr double round_off = 1e-12;
    noise.insert(noise.end(), count, std::max(std::sqrt(square), round_off * largest));
  }
  return noise;
}

std::vector<std::size_t> maxima(const std::vector<double>& values, const std::vector<double>& threshold) {
  std::vector<std::size_t> found;
  bool rising = true;
  std::size_t extreme = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double beyond = rising ? values[k] - values[extreme] : values[extreme] - values[k];
    if (beyond > 0) {
      extreme = k;
    } else if (-beyond > threshold[rising ? extreme : k]) {
      if (rising && extreme > 0) found.push_back(extreme);
      rising = !rising;
      extreme = k;
    }
  }
  return found;
}

}  // namespace scree::signals
