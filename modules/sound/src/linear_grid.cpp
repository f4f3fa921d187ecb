#include "linear_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree::sound {

namespace {

using Values = std::vector<double>;

constexpr double wanted_in_width = 8, enough_in_width = 6;
constexpr double reach = 3;  // widths on each side, as in the fit of a mode

// Distance from a maximum to where the size has fallen to its root half on one side; 0 at the end of the band.
double half_width(const Values& f, const Values& size, std::size_t top, int direction) {
  const double level = size[top] * std::numbers::sqrt2 / 2;
  for (std::size_t k = top; k > 0 && k + 1 < f.size(); k += std::size_t(direction)) {
    const std::size_t next = k + std::size_t(direction);
    if (size[next] > level) continue;
    return std::abs(f[k] + (size[k] - level) / (size[k] - size[next]) * (f[next] - f[k]) - f[top]);
  }
  return 0;
}

bool is_maximum(const Values& size, std::size_t k) {
  return k > 0 && k + 1 < size.size() && size[k] >= size[k - 1] && size[k] > size[k + 1];
}

// Divides the intervals of the road within reach of a maximum.
void divide(const Values& f, double top, double width, Values& further) {
  for (std::size_t k = 0; k + 1 < f.size(); ++k) {
    if (f[k + 1] < top - reach * width || f[k] > top + reach * width) continue;
    const int parts = int(std::ceil((f[k + 1] - f[k]) / (width / wanted_in_width) - 0.5));
    for (int p = 1; p < parts; ++p) further.push_back(f[k] + p * (f[k + 1] - f[k]) / parts);
  }
}

}  // namespace

std::vector<double> further_frequencies(const scenario::SpectrumPlan& plan, const RoadSpectrum& road) {
  const Values& f = road.frequencies;
  Values further;
  for (std::size_t c = 0; c < responding(plan.observed); ++c) {
    Values size;
    for (const std::complex<double>& h : road.columns[c].response) size.push_back(std::abs(h));
    for (std::size_t k = 0; k < size.size(); ++k) {
      if (!is_maximum(size, k)) continue;
      const double low = half_width(f, size, k, -1), high = half_width(f, size, k, 1);
      const double width = 2 * (low > 0 && high > 0 ? std::min(low, high) : std::max(low, high));
      const double apart = 0.5 * (f[k + 1] - f[k - 1]);
      if (width > 0 && width < enough_in_width * apart) divide(f, f[k], width, further);
    }
  }
  std::sort(further.begin(), further.end());
  further.erase(std::unique(further.begin(), further.end()), further.end());
  return further;
}

}  // namespace scree::sound
