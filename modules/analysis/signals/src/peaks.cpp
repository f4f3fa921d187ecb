#include "scree/signals/peaks.hpp"

#include "mode_group.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/median.hpp>

namespace scree::signals {

namespace {

constexpr std::size_t most_poles = 6;        // of one fit
constexpr double least_gain = 10;            // by which another pole lowers Akaike's criterion
constexpr double least_pole_over_error = 5;  // amplitude of another pole over its error
constexpr double least_distance = 0.1;       // of two poles, over the spacing of frequencies

// Noise is measured from third differences in windows of this half width, one for each block of values.
constexpr std::size_t half_window = 50, block = 25;
// A third difference of independent values has 20 times their variance.
constexpr double gain = 20;
// Median of the square of a normal deviate.
constexpr double median_of_square = 0.4549364;

// |H|^2 of third differences.
std::vector<double> third_differences(const ResponseSpectrum& response) {
  std::vector<double> squares;
  const auto& h = response.values;
  for (std::size_t k = 0; k + 3 < h.size(); ++k)
    squares.push_back(std::norm(h[k + 3] - 3.0 * h[k + 2] + 3.0 * h[k + 1] - h[k]));
  return squares;
}

// Noise (rms) near each value.
std::vector<double> noise_of(const ResponseSpectrum& response) {
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

// Indices of maxima from which the values fall on both sides by more than the threshold there; not the ends.
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

Pole first_guess(const ResponseSpectrum& response, std::size_t top) {
  const auto side = [&](int direction) {
    return half_width(response.frequencies, response.values, top, direction);
  };
  const double narrower = std::min(side(1), side(-1));
  const double band = response.frequencies.back() - response.frequencies.front();
  return {response.frequencies[top], 2 * std::min(narrower, 0.25 * band)};
}

std::vector<FitRange> ranges_of(const ResponseSpectrum& response, const std::vector<std::size_t>& tops) {
  std::vector<FitRange> ranges;
  for (const std::size_t top : tops) {
    const Pole pole = first_guess(response, top);
    const FitRange range = range_about(response, pole, reach);
    const bool joins =
        !ranges.empty() && range.begin < ranges.back().end && ranges.back().poles.size() < most_poles;
    if (!joins) {
      ranges.push_back(range);
      continue;
    }
    ranges.back().end = std::max(range.end, ranges.back().end);
    ranges.back().poles.push_back(pole);
  }
  return ranges;
}

// Whether the frequencies within the width of the first pole tell two poles apart. Two nearer poles with
// large amplitudes that nearly cancel would fit any small deviation of a single mode.
bool are_apart(const Pole& a, const Pole& b, const ResponseSpectrum& response) {
  const std::size_t within =
      index_of(response, a.frequency + 0.5 * a.width) - index_of(response, a.frequency - 0.5 * a.width);
  return std::hypot(a.frequency - b.frequency, 0.5 * (a.width - b.width)) * double(within) >
         least_distance * a.width;
}

// Whether each pole lies within the range and is known well.
bool is_sound(const ModeFit& fit, const ResponseSpectrum& response) {
  for (std::size_t k = 0; k < fit.poles.size(); ++k) {
    const FittedMode mode = mode_of(fit, k, response);
    if (!is_within(fit.poles[k], response) ||
        !(mode.amplitude > least_pole_over_error * mode.amplitude_error))
      return false;
    for (std::size_t other = 0; other < k; ++other)
      if (!are_apart(fit.poles[k], fit.poles[other], response)) return false;
  }
  return fit.converged;
}

// The best fit in which one of the poles has become two.
ModeFit with_another_pole(const ModeFit& fit, const ResponseSpectrum& response) {
  constexpr std::array distances = {0.15, 0.35, 0.7};
  constexpr std::array shares = {0.5, 0.8};
  ModeFit best;
  best.criterion = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < fit.poles.size(); ++k)
    for (const double distance : distances)
      for (const double share : shares) {
        std::vector<Pole> poles = fit.poles;
        const Pole split = poles[k];
        poles[k] = {split.frequency - distance * split.width, share * split.width};
        poles.push_back({split.frequency + distance * split.width, share * split.width});
        if (!(poles[k].frequency > 0)) continue;
        ModeFit candidate = fit_modes(response, poles);
        if (candidate.criterion < best.criterion && is_sound(candidate, response))
          best = std::move(candidate);
      }
  return best;
}

// Adds poles while they take up structure of the residual.
void refine(ModeFit& fit, const ResponseSpectrum& response) {
  const double by_chance = 2 / std::sqrt(double(response.values.size()));
  while (fit.poles.size() < most_poles && fit.correlation > by_chance) {
    ModeFit finer = with_another_pole(fit, response);
    if (!(finer.criterion < fit.criterion - least_gain)) return;
    fit = std::move(finer);
  }
}

// Fits each group in turn, four times, since the flanks of one lie in the range of another.
std::vector<Group> fitted(const ResponseSpectrum& whole, std::vector<Group> groups) {
  constexpr int rounds = 4, refined_from = 2;
  for (int round = 0; round < rounds; ++round)
    for (std::size_t g = 0; g < groups.size(); ++g) {
      Group& group = groups[g];
      const ResponseSpectrum response = without_other_groups(whole, groups, g, group.range);
      if (round > 0 && group.fit.converged) group.fit = fit_modes(response, group.fit.poles);
      // From the poles of an earlier round the fit may no longer come to rest.
      if (round == 0 || !group.fit.converged) group.fit = fit_modes(response, group.range.poles);
      if (round >= refined_from) refine(group.fit, response);
    }
  return groups;
}

void check(const ResponseSpectrum& response, std::size_t values) {
  constexpr std::size_t least = 16;
  const auto& f = response.frequencies;
  if (f.size() != values)
    throw Error(fmt::format("modes: {} frequencies for {} values; give one for each", f.size(), values));
  if (values < least) throw Error(fmt::format("modes: {} frequencies; give {} or more", values, least));
  for (std::size_t k = 0; k < values; ++k) {
    if (!(f[k] > (k > 0 ? f[k - 1] : 0)) || !std::isfinite(f[k]))
      throw Error(fmt::format("modes: frequency {} is {} Hz; give finite frequencies above 0 that increase",
                              k, f[k]));
    if (!std::isfinite(std::norm(response.values[k])))
      throw Error(fmt::format(
          "modes: the response at {} Hz is not a finite number; leave such frequencies out", f[k]));
  }
}

std::vector<FittedMode> fitted_modes(const ResponseSpectrum& response) {
  std::vector<double> size, threshold = noise_of(response);
  for (const auto& value : response.values) size.push_back(std::abs(value));
  for (double& noise : threshold) noise *= response.only_amplitudes ? 10 : 8;
  std::vector<Group> groups;
  for (const FitRange& range : ranges_of(response, maxima(size, threshold)))
    if (range.end - range.begin >= least_values) groups.push_back({range, {}});
  std::vector<FittedMode> modes;
  groups = fitted(response, std::move(groups));
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const ModeFit& fit = groups[g].fit;
    const ResponseSpectrum inside = slice(response, groups[g].range);
    for (std::size_t k = 0; k < fit.poles.size(); ++k)
      if (fit.converged && is_within(fit.poles[k], inside) && stands_out(fit, k, inside.only_amplitudes))
        if (const auto mode = refit_locally(response, groups, g, k)) modes.push_back(*mode);
  }
  std::sort(modes.begin(), modes.end(),
            [](const FittedMode& a, const FittedMode& b) { return a.frequency < b.frequency; });
  return modes;
}

}  // namespace

std::vector<FittedMode> fit_peaks(std::span<const double> frequencies,
                                  std::span<const std::complex<double>> response, int derivative) {
  const ResponseSpectrum data{
      {frequencies.begin(), frequencies.end()}, {response.begin(), response.end()}, false, derivative};
  check(data, response.size());
  return fitted_modes(data);
}

std::vector<FittedMode> fit_peaks(std::span<const double> frequencies, std::span<const double> amplitudes,
                                  int derivative) {
  const ResponseSpectrum data{
      {frequencies.begin(), frequencies.end()}, {amplitudes.begin(), amplitudes.end()}, true, derivative};
  check(data, amplitudes.size());
  return fitted_modes(data);
}

double half_width(std::span<const double> frequencies, std::span<const std::complex<double>> response,
                  std::size_t top, int direction) {
  const double level = std::abs(response[top]) * std::numbers::sqrt2 / 2;
  for (std::size_t k = top; k > 0 && k + 1 < response.size(); k += std::size_t(direction)) {
    const std::size_t next = k + std::size_t(direction);
    const double here = std::abs(response[k]), there = std::abs(response[next]);
    if (there > level) continue;
    const double share = (here - level) / (here - there);
    const double at = frequencies[k] + share * (frequencies[next] - frequencies[k]);
    return std::abs(at - frequencies[top]);
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace scree::signals
