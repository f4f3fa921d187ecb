#include "tone_lock_in.hpp"

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

}  // namespace scree::spectrum
