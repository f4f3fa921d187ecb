#include "sweep.hpp"

#include "steady_state.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/plugin/program.hpp>

namespace scree::spectrum {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double block_periods = 5;  // of which an adaptive sweep compares the responses
constexpr double least_scale =
    0.02;  // of the largest response: what is smaller need not be steady to the tolerance

double seconds_now() { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); }

}  // namespace

Sweep::Sweep(const Start& start)
    : start_(start),
      frequencies_(first_frequencies(start.spectrum)),
      walls_(start),
      observer_(start.plan, start.spectrum.observed),
      simulation_(std::make_unique<Simulation>(start.scene, start.state)) {
  check_amplitude(start, start.spectrum.amplitude);
  observer_.values(*simulation_);
}

Sweep::Sweep(const Start& start, const State& state)
    : start_(start), observer_(start.plan, start.spectrum.observed) {
  const StateTransfer from = StateTransfer::restoring_from(state).below("spectrum/sweep");
  transfer(from);
  check_restored(from);
  Scene scene = start.scene;
  if (!points_.empty()) set_wave(scene, start.spectrum, wave());
  simulation_ = std::make_unique<Simulation>(scene, state);
  walls_.check_restored(from.below("walls"), simulation_->absent_walls().size());
  observer_.check_restored(*simulation_);
}

State Sweep::save() {
  State state = simulation_->state();
  transfer(StateTransfer::saving_to(state).below("spectrum/sweep"));
  return state;
}

void Sweep::transfer(const StateTransfer& state) {
  observer_.transfer(state.below("observer"));
  walls_.transfer(state.below("walls"));
  state.rows("frequencies", "1/s", frequencies_, 1, stored::positive);
  state.value("wall", "s", wall_time_, stored::non_negative);
  state.value("phase", "rad", phase_);
  state.value("began_phase", "rad", began_phase_);
  std::uint64_t count = points_.size();
  state.value("points", "1", count, stored::at_most(frequencies_.size()));
  points_.resize(count);
  for (std::size_t k = 0; k < points_.size(); ++k)
    points_[k].transfer(state.below(std::to_string(k)), start_.spectrum.observed.size());
}

void Sweep::check_restored(const StateTransfer& state) const {
  const std::vector<double> planned = start_.spectrum.frequencies(),
                            first = first_frequencies(start_.spectrum);
  const bool begins =
      frequencies_.size() >= first.size() && std::equal(first.begin(), first.end(), frequencies_.begin());
  if (!begins || !std::all_of(frequencies_.begin(), frequencies_.end(), [&](double f) {
        return std::binary_search(planned.begin(), planned.end(), f);
      }))
    state.refuse("frequencies", "are not those of the scenario");
  for (std::size_t k = 0; k < points_.size(); ++k)
    if (points_[k].frequency != frequencies_[k])
      state.refuse(fmt::format("{}/frequency", k), "is not that of the sweep there");
}

std::uint64_t Sweep::steps_at(double frequency, double periods) const {
  return std::uint64_t(std::round(periods / (frequency * start_.scene.step)));
}

// The first one rises; each later one begins with the phase at which the last one ended.
Wave Sweep::wave_at(double frequency) const {
  const bool first = points_.size() <= 1 && frequency == frequencies_.front();
  const double rise = first ? start_.spectrum.sweep.rise_periods / frequency : 0;
  return {Program::drive, 0, start_.spectrum.amplitude, rise, frequency, began_phase_};
}

void Sweep::run(const std::function<void()>& measured) {
  while (true) {
    if (points_.size() == frequencies_.size()) {
      const std::vector<double> further = further_frequencies(start_.spectrum, points_);
      if (further.empty()) return;
      frequencies_.insert(frequencies_.end(), further.begin(), further.end());
    }
    const auto began = Clock::now();
    auto point = measure(frequencies_[points_.size()]);
    wall_time_ += std::chrono::duration<double>(Clock::now() - began).count();
    if (!point) return;
    points_.push_back(std::move(*point));
    measured();
  }
}

std::optional<SweepPoint> Sweep::measure(double frequency) {
  SweepPoint point{.frequency = frequency, .start = simulation_->time(), .columns = {}};
  began_phase_ = phase_;
  tone_first_ = simulation_->steps();
  start_wave(*simulation_, start_.spectrum, wave_at(frequency));
  if (!(start_.spectrum.sweep.adaptive ? measure_until_steady(point) : measure_last_periods(point)))
    return std::nullopt;
  point.steps = simulation_->steps() - tone_first_;
  const double cycles = frequency * double(point.steps) * start_.scene.step;
  phase_ = std::fmod(began_phase_ + two_pi * (cycles - std::floor(cycles)), two_pi);
  return point;
}

bool Sweep::measure_last_periods(SweepPoint& point) {
  const SpectrumPlan& plan = start_.spectrum;
  const bool averaged = plan.sweep.detrending == SweepSettings::Detrending::period_average;
  Tone tone(plan, point.frequency, plan.sweep.analysed_periods, averaged);
  ToneHalves halves(plan, point.frequency,
                    (plan.sweep.periods - 0.5 * plan.sweep.analysed_periods) / point.frequency);
  const std::uint64_t first = steps_at(point.frequency, plan.sweep.periods - plan.sweep.analysed_periods);
  const auto add = [&](double time, double drive, const std::vector<double>& values) {
    tone.add(time, drive, values);
    halves.add(time, drive, values);
  };
  if (!record(add, point.frequency, first, steps_at(point.frequency, plan.sweep.periods))) return false;
  point.drive = tone.amplitude();
  point.columns = tone.columns();
  point.periods = plan.sweep.periods;
  point.is_steady = !halves.differ(scales());
  return true;
}

bool Sweep::measure_until_steady(SweepPoint& point) {
  const SpectrumPlan& plan = start_.spectrum;
  SteadyState steady(plan.sweep.tolerance, scales());
  point.periods = points_.empty() ? plan.sweep.rise_periods : 0;
  do {
    // The mean over a period would take one of few.
    Tone tone(plan, point.frequency, block_periods, false);
    const std::uint64_t first = steps_at(point.frequency, point.periods);
    point.periods += block_periods;
    const auto add = [&](double time, double drive, const std::vector<double>& values) {
      tone.add(time, drive, values);
    };
    if (!record(add, point.frequency, first, steps_at(point.frequency, point.periods))) return false;
    point.drive = tone.amplitude();
    steady.add(tone.columns());
  } while (!steady.is_reached() && point.periods + block_periods <= longest * plan.sweep.periods);
  point.is_steady = steady.is_reached();
  point.columns = steady.limits();
  return true;
}

std::vector<double> Sweep::scales() const {
  std::vector<double> largest(responding(start_.spectrum.observed), 0.0);
  for (const SweepPoint& point : points_)
    for (std::size_t c = 0; c < largest.size(); ++c)
      largest[c] = std::max(largest[c], least_scale * std::abs(point.columns[c].response));
  return largest;
}

bool Sweep::record(const AddSample& add, double frequency, std::uint64_t first, std::uint64_t last) {
  const double step = start_.scene.step,
               interval = 1 / (frequency * start_.spectrum.sweep.samples_per_period * step);
  std::uint64_t latest = last + 1;
  for (double k = std::ceil((double(first) - 0.5) / interval);; ++k) {
    const auto at = std::uint64_t(std::round(k * interval));
    if (at > last) break;
    if (at < first || at == latest) continue;
    if (!advance_to(tone_first_ + at)) return false;
    add(double(at) * step, drive_at(frequency, double(at) * step), observer_.values(*simulation_));
    report_progress();
    latest = at;
  }
  return advance_to(tone_first_ + last);
}

double Sweep::drive_at(double frequency, double time) const {
  return walls_.are_prescribed()
             ? walls_.drive_of(*simulation_)
             : start_.spectrum.amplitude * std::sin(two_pi * frequency * time + began_phase_);
}

bool Sweep::advance_to(std::uint64_t step) {
  while (simulation_->steps() < step) {
    simulation_->run(step - simulation_->steps(), [this] { return start_.proceeds(); });
    if (!start_.proceeds()) return false;
  }
  return true;
}

void Sweep::report_progress() {
  constexpr double seconds_between_reports = 0.2;
  const double now = seconds_now();
  if (now - last_report_ < seconds_between_reports) return;
  last_report_ = now;
  double done = double(simulation_->steps() - tone_first_), all = 0;
  for (std::size_t k = 0; k < frequencies_.size(); ++k) {
    const double steps = double(
        k < points_.size() ? points_[k].steps : steps_at(frequencies_[k], start_.spectrum.sweep.periods));
    all += steps;
    if (k < points_.size()) done += steps;
  }
  start_.on_progress(std::min(1.0, done / all),
                     fmt::format("sweep, frequency {} of {}", points_.size() + 1, frequencies_.size()));
}

std::vector<MethodSpectrum> Sweep::spectra() const {
  using Direction = SweepSettings::Direction;
  const SpectrumPlan& plan = start_.spectrum;
  if (plan.sweep.direction != Direction::both)
    return {spectrum_of(plan.sweep.direction == Direction::down ? "sweep_down" : "sweep", 0, points_.size())};
  const std::size_t half = frequencies_.size() / 2;
  std::vector<MethodSpectrum> all = {spectrum_of("sweep", 0, half)};
  if (points_.size() > half) all.push_back(spectrum_of("sweep_down", half, points_.size()));
  return all;
}

MethodSpectrum Sweep::spectrum_of(const char* name, std::size_t first, std::size_t last) const {
  MethodSpectrum spectrum{.method = name, .frequencies = {}, .columns = {}, .notes = {}};
  std::vector<SweepPoint> points(points_.begin() + std::ptrdiff_t(std::min(first, points_.size())),
                                 points_.begin() + std::ptrdiff_t(std::min(last, points_.size())));
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.frequency < b.frequency; });
  spectrum.columns.resize(start_.spectrum.observed.size());
  std::size_t unsteady = 0;
  for (const SweepPoint& point : points) {
    spectrum.frequencies.push_back(point.frequency);
    spectrum.steps += point.steps;
    unsteady += !point.is_steady;
    for (std::size_t c = 0; c < point.columns.size(); ++c) {
      spectrum.columns[c].response.push_back(point.columns[c].response);
      spectrum.columns[c].error.push_back(point.columns[c].error);
    }
  }
  const SpectrumPlan& plan = start_.spectrum;
  if (unsteady)
    spectrum.notes.push_back(fmt::format(
        "{}: at {} of {} the response was not steady after {:g} periods{}; give a larger "
        "spectrum.sweep.tolerance or more spectrum.sweep.periods",
        name, unsteady, counted(points.size(), "frequency", "frequencies"),
        (plan.sweep.adaptive ? longest : 1) * plan.sweep.periods,
        plan.sweep.adaptive ? "" : ", since that of the second half of the analysed periods is another one"));
  spectrum.note_silent(start_.spectrum.observed);
  double all_steps = 0;
  for (const SweepPoint& point : points_) all_steps += double(point.steps);
  spectrum.wall_time = spectrum.steps ? wall_time_ * double(spectrum.steps) / all_steps : 0;
  return spectrum;
}

}  // namespace scree::spectrum
