#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <span>

#include <scree/error.hpp>
#include <scree/plugin/formatted.hpp>

namespace scree {

// Subtracts from each sample the mean of the signal over the period around it, as Lemrich et al. (2017) do
// with the strain of a driven packing. The mean is the integral over [t - P/2, t + P/2] of the samples
// connected by straight lines, divided by P.
//
// A sine of frequency 1/P keeps amplitude and phase, since its mean over a period is sinc(1) = 0, and so do
// its harmonics (sinc(2) = sinc(3) = 0). For samples at equal steps h the line through them also holds the
// images f + m/h with amplitudes sinc^2(f h + m), of which the mean keeps sinc(1 + m n), n = P/h:
//   n integer: exactly 0, so that amplitude and phase are exact; else the relative error is at most (f h)^3.
// For steps up to h it is at most (2 pi f h)^2 / 12: the error of the trapezoidal rule, h^2 x''/12.
// Other frequencies v are multiplied by 1 - sinc(v/f).
//
// Of a drift c t nothing is left, of c t^2 the constant -c P^2/12, of c t^3 the line -c P^2 t/4.
// Half a period at each end of the record is lost.
class PeriodAverage {
 public:
  using Emit = std::function<void(double time, double value)>;

  // Number of doubles that are kept, whatever the length of the record, for at most so many samples in a
  // period.
  static std::size_t state_size(std::size_t samples_per_period) {
    return head + sample_size * (samples_per_period + spare);
  }

  // period: (s). Continues from `state`; all zeros: no sample yet. The memory is the caller's and is the
  // whole state. Throws Error for a period that is not above 0, and for a state for fewer than 2 samples per
  // period or with counts that add() does not leave.
  PeriodAverage(double period, std::span<double> state) : period_(period), state_(state) {
    if (!(period > 0 && std::isfinite(period)))
      throw Error(formatted("period average: period %.10g; give a period above 0 in s", period));
    if (state.size() < state_size(2))
      throw Error(
          formatted("period average: a state of %zu numbers; give %zu or more", state.size(), state_size(2)));
    check_counts();
  }

  // Adds a sample at a time (s) after the last, and emits those around which a whole period is known now.
  // Throws Error if a period has more samples than fit.
  void add(double time, double value, const Emit& emit) {
    const std::size_t number = std::size_t(state_[count]);
    if (number == 0) state_[reference] = value;
    Sample added{time, value - state_[reference], 0};
    if (number > 0) {
      const Sample before = sample(number - 1);
      added.integral = before.integral + 0.5 * (time - before.time) * (before.value + added.value);
    }
    drop_old(number);
    if (number - std::size_t(state_[oldest]) == size_of_ring())
      throw Error(
          formatted("period average: more than %zu samples in a period of %.10g s; give room for more",
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
      // The sample is multiplied by the length, so that round-off of the ends counts with the slope, not the
      // value.
      emit(at.time, (at.value * (to - from) - (integral_to(to) - integral_to(from))) / period_);
    }
  }

 private:
  // The state: samples so far, number of the oldest that is kept and of the next to be emitted, first value;
  // then a ring of samples.
  enum Place : std::size_t { count, oldest, centre, reference, head };
  static constexpr std::size_t sample_size = 3;
  // The ring holds a period and three samples more: one beyond each end, and the new one.
  static constexpr std::size_t spare = 3;

  struct Sample {
    double time, value, integral;  // value less the first one; its integral since an earlier sample
  };

  // A state from a file may claim more samples than the ring holds.
  void check_counts() const {
    const double first = state_[oldest], next = state_[centre], end = state_[count];
    if (!(first >= 0 && first <= next && next <= end && end < 0x1p53 &&
          end - first <= double(size_of_ring())))
      throw Error(
          "period average: the numbers of its samples do not fit; take a state that scree has written");
  }

  std::size_t size_of_ring() const { return (state_.size() - head) / sample_size; }

  Sample sample(std::size_t number) const {
    const double* at = state_.data() + head + sample_size * (number % size_of_ring());
    return {at[0], at[1], at[2]};
  }
  void set(std::size_t number, const Sample& sample) {
    double* at = state_.data() + head + sample_size * (number % size_of_ring());
    at[0] = sample.time, at[1] = sample.value, at[2] = sample.integral;
  }

  // Drops the samples before the period around the next one to be emitted.
  void drop_old(std::size_t end) {
    const std::size_t next = std::size_t(state_[centre]);
    if (next >= end) return;
    const double from = sample(next).time - 0.5 * period_;
    while (state_[oldest] + 1 < double(end) && sample(std::size_t(state_[oldest]) + 1).time <= from)
      state_[oldest] += 1;
  }

  // Restarts the integral at a sample: one since the start would lose digits in a long record.
  void rebase(std::size_t first, std::size_t end) {
    const double base = sample(first).integral;
    for (std::size_t k = first; k < end; ++k) {
      Sample kept = sample(k);
      kept.integral -= base;
      set(k, kept);
    }
  }

  double integral_to(double time) const {
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

  double period_;
  std::span<double> state_;
};

}  // namespace scree
