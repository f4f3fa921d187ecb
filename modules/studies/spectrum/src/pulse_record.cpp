#include "pulse_record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <scree/packing/random.hpp>
#include <scree/plugin/program.hpp>
#include <scree/signals/band_noise.hpp>

namespace scree::spectrum {

namespace {

using Form = PulseSettings::Form;

// The pulse begins with less than 1e-13 of its amplitude.
constexpr double gaussian_lead = 8;  // widths
constexpr double ricker_lead = 2.2;  // periods
// Of the run without a pulse and the first with one, in the steps of all three.
constexpr double share_of_driven = 2.0 / 3;

double gaussian_width(const SpectrumPlan& plan) { return 0.25 / plan.to_hz; }
double ricker_frequency(const SpectrumPlan& plan) { return 0.5 * (plan.from_hz + plan.to_hz); }

Wave chirp(const SpectrumPlan& plan, double amplitude) {
  const double margin = PulseSettings::band_margin * plan.from_hz, low = plan.from_hz - margin,
               high = plan.to_hz + margin;
  const double rise = margin / (high - low) * plan.pulse.chirp_duration;
  return {Program::chirp, 0, amplitude, rise, low, high, plan.pulse.chirp_duration, 0};
}

}  // namespace

PulseRecord::PulseRecord(const Start& start, const DrivenWalls& walls, double amplitude,
                         PulseRecord* undriven)
    : start_(start),
      walls_(walls),
      undriven_(undriven),
      observer_(start.plan, start.spectrum.observed),
      simulation_(std::make_unique<Simulation>(start.scene, start.state)),
      first_(simulation_->steps()),
      wave_(wave(amplitude)) {
  const SpectrumPlan& plan = start.spectrum;
  stride_ = std::max<std::uint64_t>(
      1, std::uint64_t(1 / (plan.to_hz * plan.pulse.samples_per_period * start.scene.step)));
  at_start_ = observer_.values(*simulation_);
  columns_.assign(at_start_.size(), {0.0});
  drive_ = {0.0};
  start_wave(*simulation_, plan, wave_);
}

Wave PulseRecord::wave(double amplitude) const {
  const SpectrumPlan& plan = start_.spectrum;
  if (plan.pulse.form == Form::chirp) return chirp(plan, amplitude);
  if (plan.pulse.form == Form::noise) return noise(amplitude);
  if (plan.pulse.form == Form::gaussian)
    return {Program::gaussian, 0, amplitude, gaussian_lead * gaussian_width(plan), gaussian_width(plan)};
  return {Program::ricker, 0, amplitude, ricker_lead / ricker_frequency(plan), ricker_frequency(plan)};
}

// Straight lines between the middles of steps: at a step, their slope is the central difference.
Wave PulseRecord::noise(double amplitude) const {
  const SpectrumPlan& plan = start_.spectrum;
  const double step = start_.scene.step, rise = 1 / plan.from_hz,
               duration = plan.pulse.noise_duration + 2 * rise;
  const double margin = PulseSettings::band_margin * plan.from_hz;
  if (amplitude == 0) return {Program::constant, 0};
  packing::Random random(start_.plan.seed);
  const std::vector<double> values = signals::band_noise(
      std::size_t(duration / step), std::size_t(std::ceil((plan.from_hz - margin) * duration)),
      std::size_t((plan.to_hz + margin) * duration), [&] { return random.normal(); });
  Wave wave = {Program::table, 0, 0};
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double time = (double(k) + 0.5) * step;
    wave.insert(wave.end(), {time, amplitude * waveform::rise(time, rise).value * values[k]});
  }
  return wave;
}

double PulseRecord::end_of_pulse() const {
  const SpectrumPlan& plan = start_.spectrum;
  if (plan.pulse.form == Form::noise) return plan.pulse.noise_duration;
  return plan.pulse.form == Form::chirp ? plan.pulse.chirp_duration : 2 * wave_[3];
}

double PulseRecord::interval() const { return double(stride_) * start_.scene.step; }

bool PulseRecord::sample_next() {
  if (undriven_ && !undriven_->until_samples(samples() + 1)) return false;
  const std::uint64_t next = simulation_->steps() + stride_;
  while (simulation_->steps() < next) {
    simulation_->run(next - simulation_->steps(), [this] { return start_.proceeds(); });
    if (!start_.proceeds()) return false;
  }
  const std::vector<double>& values = observer_.values(*simulation_);
  for (std::size_t c = 0; c < values.size(); ++c)
    columns_[c].push_back(values[c] - at_start_[c] - (undriven_ ? undriven_->columns_[c][samples()] : 0));
  const scree_value program = {.data = wave_.data(), .count = wave_.size()};
  drive_.push_back(walls_.are_prescribed()
                       ? walls_.drive_of(*simulation_)
                       : Program(program)(double(simulation_->steps() - first_) * start_.scene.step));
  return true;
}

// Samples of one period of the lowest frequency, or of the longest record.
std::size_t PulseRecord::block() const {
  const double seconds = std::min(1 / start_.spectrum.from_hz, start_.spectrum.pulse.longest_record());
  return std::size_t(seconds / interval()) + 1;
}

bool PulseRecord::until_decay() {
  const SpectrumPlan& plan = start_.spectrum;
  while (length() < plan.pulse.longest_record()) {
    for (std::size_t k = 0; k < block(); ++k)
      if (!sample_next()) return false;
    start_.on_progress(std::min(share_of_driven, share_of_driven * length() / plan.pulse.longest_record()),
                       "pulse");
    bool decayed = length() > end_of_pulse() + 1 / plan.from_hz;
    for (std::size_t c = 0; c < responding(plan.observed); ++c) decayed &= tail(c) < plan.pulse.decay;
    if (decayed) return true;
  }
  return true;
}

bool PulseRecord::until_samples(std::size_t samples) {
  while (drive_.size() < samples) {
    if (!sample_next()) return false;
    if (undriven_ && drive_.size() % 1024 == 0)
      start_.on_progress(share_of_driven + (1 - share_of_driven) * double(drive_.size()) / double(samples),
                         "pulse of half the amplitude");
  }
  return true;
}

double PulseRecord::largest(std::size_t column, std::size_t first, std::size_t last) const {
  double largest = 0;
  for (std::size_t k = first; k < std::min(last, samples()); ++k)
    largest = std::max(largest, std::abs(columns_[column][k]));
  return largest;
}

double PulseRecord::tail(std::size_t column) const {
  double sum = 0;
  for (const double y : columns_[column]) sum += std::abs(y);
  return sum > 0 ? beyond(column) / (sum * interval()) : 0;
}

double PulseRecord::beyond(std::size_t column) const {
  const std::size_t end = samples(), size = std::min(block(), end / 2), middle = end / 2;
  const double late = largest(column, end - size, end), before = largest(column, middle, middle + size);
  if (late == 0) return 0;
  if (before <= late) return std::numeric_limits<double>::infinity();
  const double apart = double(end - size - middle) * interval();
  return late * apart / std::log(before / late);
}

std::complex<double> PulseRecord::integral(const std::vector<double>& values, double frequency) const {
  const double dt = interval();
  const std::complex<double> turn = std::polar(1.0, -2 * std::numbers::pi * frequency * dt);
  std::complex<double> sum = 0, phase = 1;
  for (std::size_t k = 0; k < values.size(); ++k) {
    // Anew from time to time, so that round-off does not grow.
    if (k % 256 == 0)
      phase = std::polar(1.0, -2 * std::numbers::pi * std::fmod(frequency * dt * double(k), 1.0));
    sum += values[k] * phase;
    phase *= turn;
  }
  return dt * sum;
}

}  // namespace scree::spectrum
