#include "tone.hpp"

#include <algorithm>
#include <cmath>

namespace scree::spectrum {

namespace {

LockInOptions options_of(double frequency, double length, bool averaged, int drift_degree) {
  LockInOptions options;
  options.frequency = frequency;
  options.duration = averaged ? length - 1 / frequency : length;
  options.harmonics = 1;
  options.drift_degree = averaged ? 0 : drift_degree;
  return options;
}

constexpr int sweep_drift_degree = 3;

// Steps are rounded, so that a period may have some more samples.
std::size_t most_samples(const SpectrumPlan& plan) { return std::size_t(plan.sweep.samples_per_period) + 4; }

constexpr double fewest_periods = 3, fewest_samples = 12;  // of a half
constexpr double many_errors = 5;

}  // namespace

ToneLockIn::ToneLockIn(double frequency, double length, std::size_t samples_per_period, bool averaged,
                       int drift_degree)
    : options_(options_of(frequency, length, averaged, drift_degree)),
      fit_state_(LockIn::state_size(options_)),
      fit_(options_, fit_state_) {
  if (!averaged) return;
  average_state_.resize(PeriodAverage::state_size(samples_per_period));
  average_.emplace(1 / frequency, average_state_);
}

void ToneLockIn::add(double time, double value) {
  // Differences to the first value are small, so that sums of their squares keep their digits.
  if (samples_++ == 0) origin_ = value;
  sum_ += value - origin_;
  if (average_)
    average_->add(time, value - origin_, [this](double t, double rest) { fit_.add(t, rest); });
  else
    fit_.add(time, value - origin_);
}

ToneLockIn::Amplitude ToneLockIn::result() const {
  const SpectralLine line = fit_.result().lines[0];
  return {std::polar(line.amplitude, line.phase), line.amplitude_error, origin_ + sum_ / double(samples_)};
}

Tone::Tone(const SpectrumPlan& plan, double frequency, double periods, bool averaged)
    : plan_(plan), drive_(frequency, periods / frequency, most_samples(plan), false, 1) {
  for (std::size_t c = 0; c < plan.observed.size(); ++c)
    columns_.emplace_back(frequency, periods / frequency, most_samples(plan), averaged, sweep_drift_degree);
}

void Tone::add(double time, double drive, const std::vector<double>& values) {
  drive_.add(time, drive);
  for (std::size_t c = 0; c < columns_.size(); ++c) columns_[c].add(time, values[c]);
}

std::vector<SweepPoint::Column> Tone::columns() const {
  const std::complex<double> drive = drive_.result().value;
  std::vector<SweepPoint::Column> all;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const ToneLockIn::Amplitude found = columns_[c].result();
    const double scale = plan_.observed[c].relative ? 1 / std::abs(found.mean) : 1;
    all.push_back({scale * found.value / drive, scale * found.error / std::abs(drive), found.mean});
  }
  return all;
}

ToneHalves::ToneHalves(const SpectrumPlan& plan, double frequency, double middle)
    : plan_(plan), middle_(middle) {
  const double periods = 0.5 * plan.sweep.analysed_periods;
  if (periods < fewest_periods || periods * plan.sweep.samples_per_period < fewest_samples) return;
  // The mean over a period would take one of few.
  first_.emplace(plan, frequency, periods, false);
  second_.emplace(plan, frequency, periods, false);
}

void ToneHalves::add(double time, double drive, const std::vector<double>& values) {
  if (first_) (time < middle_ ? first_ : second_)->add(time, drive, values);
}

bool ToneHalves::differ(const std::vector<double>& scales) const {
  if (!first_) return false;
  const std::vector<SweepPoint::Column> before = first_->columns(), after = second_->columns();
  for (std::size_t c = 0; c < scales.size(); ++c) {
    const double change = std::abs(after[c].response - before[c].response),
                 response = std::max(std::abs(after[c].response), scales[c]);
    if (change > plan_.sweep.tolerance * response &&
        change > many_errors * std::hypot(before[c].error, after[c].error))
      return true;
  }
  return false;
}

}  // namespace scree::spectrum
