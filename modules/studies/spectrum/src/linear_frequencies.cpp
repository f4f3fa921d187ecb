#include "linear_frequencies.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>

#include <scree/signals/peaks.hpp>

namespace scree::spectrum {

namespace {

using Values = std::vector<double>;

constexpr double wanted_in_width = 8, enough_in_width = 6;
constexpr double reach = 3;  // widths on each side, as in the fit of a mode

bool is_maximum(const Values& size, std::size_t k) {
  return k > 0 && k + 1 < size.size() && size[k] >= size[k - 1] && size[k] > size[k + 1];
}

// Divides the intervals of the grid within reach of a maximum.
void divide(const Values& f, double top, double width, Values& further) {
  for (std::size_t k = 0; k + 1 < f.size(); ++k) {
    if (f[k + 1] < top - reach * width || f[k] > top + reach * width) continue;
    const int parts = int(std::ceil((f[k + 1] - f[k]) / (width / wanted_in_width) - 0.5));
    for (int p = 1; p < parts; ++p) further.push_back(f[k] + p * (f[k + 1] - f[k]) / parts);
  }
}

}  // namespace

std::vector<double> frequencies_about_maxima(const SpectrumPlan& plan, const MethodSpectrum& spectrum) {
  const Values& f = spectrum.frequencies;
  Values further;
  for (std::size_t c = 0; c < responding(plan.observed); ++c) {
    const std::vector<std::complex<double>>& response = spectrum.columns[c].response;
    Values size;
    for (const std::complex<double>& h : response) size.push_back(std::abs(h));
    for (std::size_t k = 0; k < size.size(); ++k) {
      if (!is_maximum(size, k)) continue;
      const double width =
          2 * std::min(signals::half_width(f, response, k, -1), signals::half_width(f, response, k, 1));
      if (width < enough_in_width * 0.5 * (f[k + 1] - f[k - 1])) divide(f, f[k], width, further);
    }
  }
  std::sort(further.begin(), further.end());
  further.erase(std::unique(further.begin(), further.end()), further.end());
  return further;
}

std::vector<double> missing(const std::vector<double>& all, const std::vector<double>& found) {
  std::vector<double> left;
  std::set_difference(all.begin(), all.end(), found.begin(), found.end(), std::back_inserter(left));
  return left;
}

std::vector<double> first_batch(std::vector<double> frequencies, std::size_t bodies) {
  // Translations and rotations are complex numbers.
  constexpr double most_bytes = 2e9, bytes_per_body = 6 * 16;
  constexpr std::size_t fewest = 48;  // which share a factorisation
  const auto most = std::size_t(most_bytes / (bytes_per_body * double(std::max<std::size_t>(bodies, 1))));
  frequencies.resize(std::min(frequencies.size(), std::max(most, fewest)));
  return frequencies;
}

}  // namespace scree::spectrum
