#include "scree/signals/period_average.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::signals {

namespace {

// The state: samples so far, number of the oldest that is kept and of the next to be emitted, first value; then the ring.
enum Entry : std::size_t { count, oldest, centre, reference, head };
constexpr std::size_t sample_size = 3;
// Beside the samples of a period: those beyond both ends and the new one.
constexpr std::size_t spare = 3;

}  // namespace

struct PeriodAverage::Sample {
  double time, value, integral;  // value less the first one; its integral since an earlier sample
};

std::size_t PeriodAverage::state_size(std::size_t samples_per_period) {
  return head + sample_size * (samples_per_period + spare);
}

PeriodAverage::PeriodAverage(double period, std::span<double> state) : period_(period), state_(state) {
  if (!(period > 0 && std::isfinite(period)))
    throw Error(fmt::format("period average: period {}; give a period above 0 in s", period));
  if (state.size() < state_size(2))
    throw Error(
        fmt::format("period average: a state of {} numbers; give {} or more", state.size(), state_size(2)));
  check_counts();
}

// Samples are counted: what comes from a file may claim more than the ring holds.
void PeriodAverage::check_counts() const {
  const double first = state_[oldest], next = state_[centre], end = state_[count];
  if (!(first >= 0 && first <= next && next <= end && end < 0x1p53 && end - first <= double(size_of_ring())))
    throw Error("period average: the numbers of its samples do not fit; take a state that scree has written");
}

std::size_t PeriodAverage::size_of_ring() const { return (state_.size() - head) / sample_size; }

PeriodAverage::Sample PeriodAverage::sample(std::size_t number) const {
  const double* at = state_.data() + head + sample_size * (number % size_of_ring());
  return {at[0], at[1], at[2]};
}

void PeriodAverage::set(std::size_t number, const Sample& sample) {
  double* at = state_.data() + head + sample_size * (number % size_of_ring());
  at[0] = sample.time, at[1] = sample.value, at[2] = sample.integral;
}

// Forgets what lies before the period around the next sample to be emitted.
void PeriodAverage::drop_old(std::size_t end) {
  const std::size_t next = std::size_t(state_[centre]);
  if (next >= end) return;
  const double from = sample(next).time - 0.5 * period_;
  while (state_[oldest] + 1 < double(end) && sample(std::size_t(state_[oldest]) + 1).time <= from)
    state_[oldest] += 1;
}

// An integral since the start would lose digits in a long record.
void PeriodAverage::rebase(std::size_t first, std::size_t end) {
  const double base = sample(first).integral;
  for (std::size_t k = first; k < end; ++k) {
    Sample kept = sample(k);
    kept.integral -= base;
    set(k, kept);
  }
}

double PeriodAverage::integral_to(double time) const {
  std::size_t low = std::size_t(state_[oldest]), high = std::size_t(state_[count]) - 1;
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (sample(middle).time <= time ? low : high) = middle;
  }
  const Sample a = sample(low), b = sample(high);
  const double part = time - a.time;
  const double value = a.value + (b.value - a.value) * part / (b.time - a.time);
  return a.integral + part * 0.5 * (a.value + value);
}

void PeriodAverage::add(double time, double value, const Emit& emit) {
  const std::size_t number = std::size_t(state_[count]);
  if (number == 0) state_[reference] = value;
  Sample added{time, value - state_[reference], 0};
  if (number > 0) {
    const Sample before = sample(number - 1);
    added.integral = before.integral + 0.5 * (time - before.time) * (before.value + added.value);
  }
  drop_old(number);
  if (number - std::size_t(state_[oldest]) == size_of_ring())
    throw Error(fmt::format("period average: more than {} samples in a period of {} s; give room for more",
                            size_of_ring() - spare, period_));
  set(number, added);
  state_[count] += 1;
  if (number % size_of_ring() == 0) rebase(std::size_t(state_[oldest]), number + 1);
  // Round-off of the times must not move a sample at the very end of the period out of it.
  const double tolerance = 1e-9 * period_;
  for (std::size_t next = std::size_t(state_[centre]); next <= number; ++next) {
    const Sample at = sample(next);
    const double from = at.time - 0.5 * period_, to = at.time + 0.5 * period_;
    if (to > time + tolerance) return;
    drop_old(number + 1);
    state_[centre] += 1;
    if (from < sample(std::size_t(state_[oldest])).time - tolerance) continue;
    // Less the sample itself, so that round-off of the ends counts with the slope and not with the value.
    emit(at.time, (at.value * (to - from) - (integral_to(to) - integral_to(from))) / period_);
  }
}

}  // namespace scree::signals
