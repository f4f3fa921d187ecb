#include "scree/signals/peaks.hpp"

#include "maxima.hpp"
#include "mode_group.hpp"
#include "mode_of_pole.hpp"
#include "near_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::signals {

namespace {

constexpr std::size_t most_poles = 6;        // of one fit
constexpr double least_gain = 10;            // of Akaike's criterion, for another pole
constexpr double least_pole_over_error = 5;  // amplitude of another pole
constexpr double least_distance = 0.1;       // of two poles, over the spacing of frequencies

Pole first_guess(const Response& response, std::size_t top) {
  const auto side = [&](int direction) {
    return half_width(response.frequencies, response.values, top, direction);
  };
  const double narrower = std::min(side(1), side(-1));
  const double band = response.frequencies.back() - response.frequencies.front();
  return {response.frequencies[top], 2 * std::min(narrower, 0.25 * band)};
}

std::vector<Range> ranges_of(const Response& response, const std::vector<std::size_t>& tops) {
  std::vector<Range> ranges;
  for (const std::size_t top : tops) {
    const Pole pole = first_guess(response, top);
    const Range range = range_about(response, pole, reach);
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

// Whether two poles are told apart by frequencies with the spacing of those in the width of the first. Two that are nearer, with large amplitudes
// that nearly cancel, fit any small deviation of a single mode.
bool are_apart(const Pole& a, const Pole& b, const Response& response) {
  const std::size_t within =
      index_of(response, a.frequency + 0.5 * a.width) - index_of(response, a.frequency - 0.5 * a.width);
  return std::hypot(a.frequency - b.frequency, 0.5 * (a.width - b.width)) * double(within) >
         least_distance * a.width;
}

// Whether each pole is within the range and known well.
bool is_sound(const ModeFit& fit, const Response& response) {
  for (std::size_t k = 0; k < fit.poles.size(); ++k) {
    const Mode mode = mode_of(fit, k, response);
    if (!is_within(fit.poles[k], response) ||
        !(mode.amplitude > least_pole_over_error * mode.amplitude_error))
      return false;
    for (std::size_t other = 0; other < k; ++other)
      if (!are_apart(fit.poles[k], fit.poles[other], response)) return false;
  }
  return fit.converged;
}

// The best fit in which one of the poles has become two.
ModeFit with_another_pole(const ModeFit& fit, const Response& response) {
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
        ModeFit trial = fit_modes(response, poles);
        if (trial.criterion < best.criterion && is_sound(trial, response)) best = std::move(trial);
      }
  return best;
}

// Adds poles while the residual shows structure that they take up.
void refine(ModeFit& fit, const Response& response) {
  const double by_chance = 2 / std::sqrt(double(response.values.size()));
  while (fit.poles.size() < most_poles && fit.correlation > by_chance) {
    ModeFit finer = with_another_pole(fit, response);
    if (!(finer.criterion < fit.criterion - least_gain)) return;
    fit = std::move(finer);
  }
}

// Each group in turn, a few times over, since the flanks of one are in the range of another.
std::vector<Group> fitted(const Response& whole, std::vector<Group> groups) {
  constexpr int rounds = 4, refined_from = 2;
  for (int round = 0; round < rounds; ++round)
    for (std::size_t g = 0; g < groups.size(); ++g) {
      Group& group = groups[g];
      const Response response = alone(whole, groups, g, group.range);
      if (round > 0 && group.fit.converged) group.fit = fit_modes(response, group.fit.poles);
      // Poles of an earlier round may lie where the fit does not come to rest any more.
      if (round == 0 || !group.fit.converged) group.fit = fit_modes(response, group.range.poles);
      if (round >= refined_from) refine(group.fit, response);
    }
  return groups;
}

void check(const Response& response, std::size_t values) {
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

std::vector<Mode> modes_of(const Response& response) {
  std::vector<double> size, threshold = noise_of(response);
  for (const auto& value : response.values) size.push_back(std::abs(value));
  for (double& noise : threshold) noise *= response.only_amplitudes ? 10 : 8;
  std::vector<Group> groups;
  for (const Range& range : ranges_of(response, maxima(size, threshold)))
    if (range.end - range.begin >= least_values) groups.push_back({range, {}});
  std::vector<Mode> modes;
  groups = fitted(response, std::move(groups));
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const ModeFit& fit = groups[g].fit;
    const Response inside = part(response, groups[g].range);
    for (std::size_t k = 0; k < fit.poles.size(); ++k)
      if (fit.converged && is_within(fit.poles[k], inside) && stands_out(fit, k, inside.only_amplitudes))
        if (const auto mode = near_mode(response, groups, g, k)) modes.push_back(*mode);
  }
  std::sort(modes.begin(), modes.end(),
            [](const Mode& a, const Mode& b) { return a.frequency < b.frequency; });
  return modes;
}

}  // namespace

std::vector<Mode> find_modes(std::span<const double> frequencies,
                             std::span<const std::complex<double>> response, int derivative) {
  const Response data{
      {frequencies.begin(), frequencies.end()}, {response.begin(), response.end()}, false, derivative};
  check(data, response.size());
  return modes_of(data);
}

std::vector<Mode> find_modes(std::span<const double> frequencies, std::span<const double> amplitudes,
                             int derivative) {
  const Response data{
      {frequencies.begin(), frequencies.end()}, {amplitudes.begin(), amplitudes.end()}, true, derivative};
  check(data, amplitudes.size());
  return modes_of(data);
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
