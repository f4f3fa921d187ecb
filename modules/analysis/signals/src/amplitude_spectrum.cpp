#include "scree/signals/amplitude_spectrum.hpp"

#include "fourier.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::signals {

namespace {

// Subtracts the straight line that fits best.
void remove_line(std::span<double> values) {
  const double count = double(values.size()), middle = 0.5 * (count - 1);
  double mean = 0, slope = 0;
  for (const double x : values) mean += x / count;
  for (std::size_t j = 0; j < values.size(); ++j) slope += (double(j) - middle) * (values[j] - mean);
  const double square = count * (count * count - 1) / 12;
  for (std::size_t j = 0; j < values.size(); ++j)
    values[j] -= mean + (square > 0 ? slope / square * (double(j) - middle) : 0);
}

}  // namespace

AmplitudeSpectrum amplitude_spectrum(double step, std::span<const double> values) {
  const std::size_t count = values.size();
  if (count < 4) throw Error(fmt::format("spectrum: {} values; give 4 or more", count));
  Fourier fourier(count);
  const std::span<double> x = fourier.values();
  std::copy(values.begin(), values.end(), x.begin());
  remove_line(x);
  const std::vector<double> window = hann(count);
  for (std::size_t j = 0; j < count; ++j) x[j] *= window[j];
  const double sum = std::accumulate(window.begin(), window.end(), 0.0);
  AmplitudeSpectrum spectrum{1 / (step * double(count)), {}};
  for (const auto& number : fourier.transform()) spectrum.amplitude.push_back(2 * std::abs(number) / sum);
  // The constant and, for even counts, the alternating part have no second half at negative frequencies.
  spectrum.amplitude.front() /= 2;
  if (count % 2 == 0) spectrum.amplitude.back() /= 2;
  return spectrum;
}

double unevenness(std::span<const double> times) {
  const double step = (times.back() - times.front()) / double(times.size() - 1);
  double largest = 0;
  for (std::size_t k = 0; k < times.size(); ++k)
    largest = std::max(largest, std::abs(times[k] - times.front() - step * double(k)));
  return largest / step;
}

std::vector<double> at_equal_steps(std::span<const double> times, std::span<const double> values) {
  const double step = (times.back() - times.front()) / double(times.size() - 1);
  std::vector<double> even(values.begin(), values.end());
  std::size_t right = 1;
  for (std::size_t k = 1; k + 1 < times.size(); ++k) {
    const double time = times.front() + step * double(k);
    while (right + 1 < times.size() && times[right] < time) ++right;
    const double share = (time - times[right - 1]) / (times[right] - times[right - 1]);
    even[k] = values[right - 1] + share * (values[right] - values[right - 1]);
  }
  return even;
}

}  // namespace scree::signals
