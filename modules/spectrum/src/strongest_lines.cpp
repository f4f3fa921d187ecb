#include "line_fit.hpp"
#include "scree/spectrum/amplitude_spectrum.hpp"
#include "scree/spectrum/median.hpp"

#include <algorithm>
#include <cmath>

#include <scree/error.hpp>

namespace scree::spectrum {

namespace {

constexpr std::size_t shortest_side = 6, longest_side = 50;
constexpr double least_over_median = 5;
constexpr double least_over_error = 5;
// Below, a line has fewer periods than its window needs.
constexpr std::size_t first_bin = 3;

double median_beside(const std::vector<double>& amplitude, std::size_t k) {
  // Noise that falls with frequency is compared with itself only nearby.
  const std::size_t side = std::clamp(k / 2, shortest_side, longest_side);
  const std::size_t begin = k > side ? k - side : 1;
  const std::size_t end = std::min(amplitude.size(), k + side + 1);
  return median({amplitude.begin() + std::ptrdiff_t(begin), amplitude.begin() + std::ptrdiff_t(end)});
}

// Bins of maxima above the noise, the highest first.
std::vector<std::size_t> candidates(const std::vector<double>& amplitude) {
  std::vector<std::size_t> bins;
  for (std::size_t k = first_bin; k + 1 < amplitude.size(); ++k)
    if (amplitude[k] > amplitude[k - 1] && amplitude[k] >= amplitude[k + 1] &&
        amplitude[k] > least_over_median * median_beside(amplitude, k))
      bins.push_back(k);
  std::stable_sort(bins.begin(), bins.end(),
                   [&](std::size_t a, std::size_t b) { return amplitude[a] > amplitude[b]; });
  return bins;
}

// Behind a Hann window, bins at distances d and 1 - d from a line have amplitudes in the ratio (2 - d) : (1 + d).
double interpolated(const AmplitudeSpectrum& spectrum, std::size_t k) {
  const bool above = spectrum.amplitude[k + 1] > spectrum.amplitude[k - 1];
  const double ratio = spectrum.amplitude[above ? k + 1 : k - 1] / spectrum.amplitude[k];
  const double distance = (2 * ratio - 1) / (ratio + 1);
  return spectrum.frequency(k) + spectrum.resolution * (above ? distance : -distance);
}

// Whether a fit found what the spectrum shows at its bin, and not what another line left there.
bool is_at(const FoundLine& line, const AmplitudeSpectrum& spectrum, std::size_t k) {
  constexpr double least_share = 0.5, furthest = 2;  // of the amplitude; (resolutions)
  return line.amplitude > least_share * spectrum.amplitude[k] &&
         std::abs(line.frequency - spectrum.frequency(k)) < furthest * spectrum.resolution;
}

bool stands_out(const FoundLine& line) {
  return line.amplitude > 0 && !(line.amplitude < least_over_error * line.amplitude_error);
}

}  // namespace

std::vector<FoundLine> strongest_lines(std::span<const double> times, std::span<const double> values,
                                       const AmplitudeSpectrum& spectrum, std::size_t most,
                                       const std::function<void(double)>& on_progress) {
  std::vector<FoundLine> lines;
  std::vector<std::size_t> bins = candidates(spectrum.amplitude);
  bins.resize(std::min(bins.size(), 4 * most));  // of noise-free records, those beyond are round-off
  const auto report = [&](double share) {
    if (on_progress) on_progress(share);
  };
  // Each candidate is fitted once, in what stronger ones leave, the lines that are found several times.
  std::vector<double> rest(values.begin(), values.end());
  const double fits = double(most * (1 + rounds_together));
  for (const std::size_t k : bins) {
    if (lines.size() == most) break;
    report(double(lines.size()) / fits);
    try {
      const FoundLine line = fitted_line(interpolated(spectrum, k), times, rest);
      if (!is_at(line, spectrum, k)) continue;
      subtract(line, times, rest);
      lines.push_back(line);
    } catch (const Error&) {
      // The record is too short for this line, which then is not one to be told.
    }
  }
  const double together = double(lines.size() * rounds_together), alone = double(lines.size());
  fit_together(times, values, lines,
               [&](double share) { report((alone + share * together) / (alone + together)); });
  std::erase_if(lines, [](const FoundLine& line) { return !stands_out(line); });
  std::stable_sort(lines.begin(), lines.end(),
                   [](const FoundLine& a, const FoundLine& b) { return a.amplitude > b.amplitude; });
  return lines;
}

}  // namespace scree::spectrum
