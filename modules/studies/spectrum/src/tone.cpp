#include "tone.hpp"

#include <cmath>

namespace scree::spectrum {

namespace {

constexpr int sweep_drift_degree = 3;

// Steps are rounded, so that a period may have some more samples.
std::size_t most_samples(const scenario::SpectrumPlan& plan) {
  return std::size_t(plan.samples_per_period) + 4;
}

}  // namespace

Tone::Tone(const scenario::SpectrumPlan& plan, double frequency, double periods, bool averaged)
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

}  // namespace scree::spectrum
