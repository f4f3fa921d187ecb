#include "scree/signals/lock_in.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/plugin/period_average.hpp>

namespace scree::signals {

namespace {

std::size_t most_samples_within(double period, std::span<const double> times) {
  std::size_t most = 0, first = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    while (times[k] - times[first] > period) ++first;
    most = std::max(most, k - first + 1);
  }
  return most;
}

}  // namespace

LockInResult lock_in(std::span<const double> times, std::span<const double> values, LockInOptions options,
                     Detrending detrending) {
  if (times.size() != values.size())
    throw Error(
        fmt::format("lock-in: {} times for {} values; give one for each", times.size(), values.size()));
  if (options.duration == 0 && times.size() > 1) options.duration = times.back() - times.front();
  std::vector<double> state(LockIn::state_size(options));
  LockIn fit(options, state);
  if (detrending == Detrending::polynomial) {
    for (std::size_t k = 0; k < times.size(); ++k) fit.add(times[k], values[k]);
    return fit.result();
  }
  const double period = 1 / options.frequency;
  std::vector<double> ring(
      PeriodAverage::state_size(std::max<std::size_t>(2, most_samples_within(period, times) + 1)));
  PeriodAverage average(period, ring);
  for (std::size_t k = 0; k < times.size(); ++k)
    average.add(times[k], values[k], [&](double time, double value) { fit.add(time, value); });
  return fit.result();
}

}  // namespace scree::signals
