#include "pulse.hpp"

#include "pulse_record.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/signals/transfer_function.hpp>

namespace scree::spectrum {

namespace {

using signals::TransferFunction;

TransferFunction transfer_of(const PulseRecord& record, std::size_t column, double step_hz) {
  std::vector<double> times(record.samples());
  for (std::size_t k = 0; k < times.size(); ++k) times[k] = double(k) * record.interval();
  const auto segment = std::size_t(std::round(2 / (step_hz * record.interval())));
  return signals::transfer_function(times, record.drive(), record.column(column), segment);
}

constexpr double tolerated_change = 0.05;  // of the largest response, at half the amplitude

const char* amplitude_key(const SpectrumPlan& plan) {
  return plan.pulse.form == PulseSettings::Form::noise ? "spectrum.pulse.noise_rms" : "spectrum.amplitude";
}

MethodSpectrum::Column column_of(const PulseRecord& full, const PulseRecord& half, std::size_t c,
                                 const std::vector<double>& frequencies, double scale, const Start& start) {
  MethodSpectrum::Column column;
  const double beyond = full.beyond(c);
  const auto columns = double(start.spectrum.observed.size()), count = double(frequencies.size());
  for (const double f : frequencies) {
    start.on_progress((double(c) + double(column.response.size()) / count) / columns,
                      "response to the pulse");
    if (!start.proceeds())
      throw Error("interrupted while the response to the pulse was computed", ExitStatus::interrupted);
    const std::complex<double> drive = full.drive_at(f), h = scale * full.column_at(c, f) / drive;
    column.response.push_back(h);
    column.error.push_back(scale * beyond / std::abs(drive));
    column.linearity.push_back(std::abs(h - scale * half.column_at(c, f) / half.drive_at(f)));
  }
  return column;
}

void note_tail(const PulseRecord& record, std::size_t c, const SpectrumPlan& plan, MethodSpectrum& spectrum) {
  if (record.tail(c) < plan.pulse.decay) return;
  spectrum.notes.push_back(fmt::format(
      "pulse: after {:.3g} s {} has not decayed: what follows changes the response by {}; give a longer pulse.longest",
      record.length(), plan.observed[c].name,
      std::isfinite(record.tail(c)) ? fmt::format("about {:.2g} of its largest value", record.tail(c))
                                    : "an unknown amount"));
}

void note_change(std::size_t c, const SpectrumPlan& plan, MethodSpectrum& spectrum) {
  const MethodSpectrum::Column& column = spectrum.columns[c];
  const double change = *std::max_element(column.linearity.begin(), column.linearity.end());
  double largest = 0;
  for (const std::complex<double>& h : column.response) largest = std::max(largest, std::abs(h));
  if (!(change > tolerated_change * largest)) return;
  spectrum.notes.push_back(fmt::format(
      "pulse: at half the amplitude of {:g} m the response of {} changes by {:.2g} of its largest value, so that it is not linear; "
      "give a lower {}",
      plan.pulse_amplitude(), plan.observed[c].name, change / largest, amplitude_key(plan)));
}

// The response of a packing that moves on its own is that of many states.
void note_motion(const PulseRecord& undriven, const PulseRecord& full, std::size_t c,
                 const SpectrumPlan& plan, MethodSpectrum& spectrum) {
  if (!(undriven.largest(c) > full.largest(c))) return;
  spectrum.notes.push_back(fmt::format(
      "pulse: without the pulse {} changes by {:.2g}, with it by {:.2g} more: the packing is not at rest; let it come to rest in a stage "
      "before (until), or give a larger {}",
      plan.observed[c].name, undriven.largest(c), full.largest(c), amplitude_key(plan)));
}

// A record that ends before its pulse has no spectrum.
void check_length(const PulseRecord& record, const SpectrumPlan& plan) {
  if (plan.pulse.longest_record() >= record.end_of_pulse()) return;
  throw Error(fmt::format(
      "{}: the record of {:g} s ends before the pulse of {:g} s; give a longer pulse.longest, or a smaller step_hz",
      plan.drive_place, plan.pulse.longest_record(), record.end_of_pulse()));
}

void add_pulse_response(const PulseRecord& full, const PulseRecord& half, const Start& start,
                        MethodSpectrum& spectrum) {
  const SpectrumPlan& plan = start.spectrum;
  for (std::size_t c = 0; c < plan.observed.size(); ++c) {
    const double scale = plan.observed[c].relative ? 1 / std::abs(full.at_start(c)) : 1;
    spectrum.columns.push_back(column_of(full, half, c, spectrum.frequencies, scale, start));
    if (!plan.observed[c].of_shape) note_tail(full, c, plan, spectrum);
  }
}

// Frequencies and columns from records of noise, at full and at half the amplitude: Welch segments of 2 /
// step_hz and every second of their frequencies, which hardly correlate. Errors: of the coherence, and the
// leakage of the window, H'' / (6 T²) (transfer_function.hpp), from differences of neighbours.
void add_noise_response(const PulseRecord& full, const PulseRecord& half, const SpectrumPlan& plan,
                        MethodSpectrum& spectrum) {
  spectrum.columns.resize(plan.observed.size());
  spectrum.frequencies.clear();
  for (std::size_t c = 0; c < plan.observed.size(); ++c) {
    const TransferFunction h = transfer_of(full, c, plan.step_hz), weak = transfer_of(half, c, plan.step_hz);
    const double scale = plan.observed[c].relative ? 1 / std::abs(full.at_start(c)) : 1;
    const double slack = 1e-6 * plan.step_hz;
    for (std::size_t k = 2; k + 2 < h.h1.size(); k += 2) {
      const double f = h.frequency(k);
      if (f < plan.from_hz - slack || f > plan.to_hz + slack) continue;
      if (c == 0) spectrum.frequencies.push_back(f);
      const double leakage = std::abs(h.h1[k + 2] - 2.0 * h.h1[k] + h.h1[k - 2]) / 24;
      spectrum.columns[c].response.push_back(scale * h.h1[k]);
      spectrum.columns[c].error.push_back(scale * std::hypot(std::abs(h.h1[k]) * h.error[k], leakage));
      spectrum.columns[c].linearity.push_back(scale * std::abs(h.h1[k] - weak.h1[k]));
    }
  }
}

}  // namespace

MethodSpectrum pulse_spectrum(const Start& start) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const SpectrumPlan& plan = start.spectrum;
  const double amplitude = plan.pulse_amplitude();
  check_amplitude(start, amplitude);
  const DrivenWalls walls(start);
  PulseRecord undriven(start, walls, 0, nullptr), full(start, walls, amplitude, &undriven),
      half(start, walls, 0.5 * amplitude, &undriven);
  check_length(full, plan);
  if (!full.until_decay() || !half.until_samples(full.samples()))
    throw Error("interrupted while the response to the pulse was recorded", ExitStatus::interrupted);
  MethodSpectrum spectrum{.method = "pulse", .frequencies = plan.frequencies(), .columns = {}, .notes = {}};
  spectrum.steps = undriven.steps() + full.steps() + half.steps();
  if (plan.pulse.form == PulseSettings::Form::noise)
    add_noise_response(full, half, plan, spectrum);
  else
    add_pulse_response(full, half, start, spectrum);
  for (std::size_t c = 0; c < plan.observed.size(); ++c)
    if (!plan.observed[c].of_shape) {
      note_motion(undriven, full, c, plan, spectrum);
      note_change(c, plan, spectrum);
    }
  spectrum.note_silent(plan.observed);
  spectrum.wall_time = std::chrono::duration<double>(Clock::now() - began).count();
  return spectrum;
}

}  // namespace scree::spectrum
