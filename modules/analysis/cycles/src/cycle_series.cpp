#include "scree/cycles/cycle_series.hpp"

#include "samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::cycles {

namespace {

constexpr double least_load_change = 1e-12;  // over the load: some thousand roundings
constexpr double near_minimum = 0.25;        // over the range of the load
constexpr double repeated_load = 0.05;     // over its range; eight straight lines differ from a sine by 0.04
constexpr std::size_t most_periods = 100;  // of the load in a cycle
constexpr double least_change_in_part = 0.5;  // of the load in one of these periods, over its range
constexpr double longest_gap = 0.5;           // over the period, about a minimum and within a loop
constexpr double none = std::numeric_limits<double>::quiet_NaN();

void check(std::span<const double> times, std::span<const double> strain, std::span<const double> load,
           double period) {
  if (times.size() != strain.size() || (!load.empty() && load.size() != times.size()))
    throw Error(fmt::format("{} times, {} strains and {} loads; give one of each per sample", times.size(),
                            strain.size(), load.size()));
  if (times.size() < 2) throw Error("fewer than two samples; give two or more");
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (!std::isfinite(times[k]) || !std::isfinite(strain[k]) || (!load.empty() && !std::isfinite(load[k])))
      throw Error(fmt::format("sample {} is not finite; leave it out", k));
    if (k > 0 && !(times[k] > times[k - 1]))
      throw Error(fmt::format("time {} follows {}; give times that increase", times[k], times[k - 1]));
  }
  const double step = (times.back() - times.front()) / double(times.size() - 1);
  if (!(period >= step * (1 - same_time)))
    throw Error(
        fmt::format("a period of {:.10g} s is shorter than the {:.10g} s between samples; give the "
                    "period of the load, or sample more often",
                    period, step));
}

struct Path {
  std::vector<double> strain, load;
};

double range_of(const Path& path) {
  const auto [low, high] = std::minmax_element(path.load.begin(), path.load.end());
  return *high - *low;
}

// The samples within a cycle, and the values at both of its ends.
Path path_of(const Samples& strain, const Samples& load, double begin, double end) {
  Path path{{strain.at(begin)}, {load.at(begin)}};
  const std::size_t last = strain.after(end - 2 * strain.slack());
  for (std::size_t k = strain.after(begin); k < last; ++k) {
    path.strain.push_back(strain[k]);
    path.load.push_back(load[k]);
  }
  path.strain.push_back(strain.at(end));
  path.load.push_back(load.at(end));
  return path;
}

Loop loop_of(const Path& path) {
  const auto [low, high] = std::minmax_element(path.load.begin(), path.load.end());
  Loop loop;
  loop.load_range = *high - *low;
  if (path.load.size() < 4) {  // both ends are one point of the loop
    loop.area = loop.stiffness = none;
    return loop;
  }
  for (std::size_t k = 0; k < path.load.size(); ++k) {
    const std::size_t next = (k + 1) % path.load.size();
    // Relative to the first point, so that the area does not lose digits to a constant load.
    loop.area +=
        0.5 * (path.load[k] + path.load[next] - 2 * path.load[0]) * (path.strain[next] - path.strain[k]);
  }
  const double change =
      path.strain[std::size_t(high - path.load.begin())] - path.strain[std::size_t(low - path.load.begin())];
  loop.stiffness = change != 0 ? loop.load_range / change : none;
  return loop;
}

// Refuses a period or a start that is not the load's: the strains would be from anywhere in the cycle.
void check_load(const Path& path, double begin, double end) {
  const auto [low, high] = std::minmax_element(path.load.begin(), path.load.end());
  const double range = *high - *low, largest = std::max(std::abs(*low), std::abs(*high));
  if (!(range > least_load_change * largest))
    throw Error(fmt::format(
        "the load is {:.10g} from {:.10g} s to {:.10g} s: there is no cycle in it; give the column "
        "that is cycled with --load, or another --period or --start",
        path.load[0], begin, end));
  if (path.load[0] - *low > near_minimum * range)
    throw Error(fmt::format(
        "the load is {:.10g} at {:.10g} s, but between {:.10g} and {:.10g} in the cycle that begins there; "
        "give the time of its first minimum with --start, and its --period",
        path.load[0], begin, *low, *high));
}

// Whether the load changes by much in the first part (s) of the cycle, at as many times as the cycle has
// samples.
bool changes_within(double part, const Samples& load, const Path& path, double begin, double period) {
  const std::size_t samples = path.load.size() - 1;
  double least = path.load[0], most = path.load[0];
  for (std::size_t k = 0; k < samples; ++k) {
    const double since = period * double(k) / double(samples);
    if (since > part) break;
    least = std::min(least, load.at(begin + since));
    most = std::max(most, load.at(begin + since));
  }
  return most - least >= least_change_in_part * range_of(path);
}

// Whether the load is the same a part (s) of the cycle later, at as many times as the cycle has samples.
bool repeats_after(double part, const Samples& load, const Path& path, double begin, double period) {
  const std::size_t samples = path.load.size() - 1;
  const double allowed = repeated_load * range_of(path);
  for (std::size_t k = 0; k < samples; ++k) {
    const double since = period * double(k) / double(samples);
    const double change = load.at(begin + std::fmod(since + part, period)) - load.at(begin + since);
    if (std::abs(change) > allowed) return false;
  }
  return true;
}

// Number of periods of the load in a cycle, each with three samples or more.
std::size_t periods_in(const Samples& load, const Path& path, double begin, double period) {
  const std::size_t most = std::min(most_periods, (path.load.size() - 1) / 3);
  for (std::size_t count = most; count > 1; --count)
    if (const double part = period / double(count);
        changes_within(part, load, path, begin, period) && repeats_after(part, load, path, begin, period))
      return count;
  return 1;
}

}  // namespace

CycleSeries cycle_series(std::span<const double> times, std::span<const double> strain,
                         std::span<const double> load, const CycleTimes& cycles) {
  check(times, strain, load, cycles.period);
  const double slack = same_time * cycles.period;
  if (cycles.first_minimum < times.front() - slack)
    throw Error(fmt::format(
        "the first minimum at {:.10g} s is before the first sample at {:.10g} s; give a later one with --start",
        cycles.first_minimum, times.front()));
  const double count = std::floor((times.back() + slack - cycles.first_minimum) / cycles.period);
  if (!(count >= 1))
    throw Error(fmt::format(
        "no cycle of {:.10g} s from {:.10g} s to {:.10g} s, where the samples end; give a longer series, "
        "or another --period or --start",
        cycles.period, cycles.first_minimum, times.back()));
  const Samples strains(times, strain, cycles.period), loads(times, load, cycles.period);
  CycleSeries series;
  const double longest = longest_gap * cycles.period * (1 + same_time);
  for (std::size_t n = 0; n <= std::size_t(count); ++n) {
    const double begin = cycles.first_minimum + double(n) * cycles.period, end = begin + cycles.period;
    strains.check_gap_about(begin, longest);
    series.strain.push_back(strains.at(begin));
    if (!load.empty()) series.load.push_back(loads.at(begin));
    if (load.empty() || n == std::size_t(count)) continue;
    const Path path = path_of(strains, loads, begin, end);
    series.loops.push_back(loop_of(path));
    if (path.load.size() > 3) {
      strains.check_gaps_between(begin, end, longest);
      check_load(path, begin, end);
    }
    if (n + 1 == std::size_t(count)) series.load_periods = periods_in(loads, path, begin, cycles.period);
  }
  return series;
}

std::vector<double> strain_of_lengths(std::span<const double> length_x, std::span<const double> length_y,
                                      std::size_t first) {
  if (length_x.size() != length_y.size() || first >= length_x.size())
    throw Error(
        fmt::format("{} and {} lengths, and reference {}; give as many of each, and a reference among them",
                    length_x.size(), length_y.size(), first));
  std::vector<double> strain;
  for (std::size_t k = 0; k < length_x.size(); ++k) {
    if (!(length_x[k] > 0 && length_y[k] > 0 && std::isfinite(length_x[k]) && std::isfinite(length_y[k])))
      throw Error(
          fmt::format("lengths {} and {} in sample {}; give lengths above 0", length_x[k], length_y[k], k));
    strain.push_back(length_y[k] / length_y[first] - length_x[k] / length_x[first]);
  }
  return strain;
}

}  // namespace scree::cycles
