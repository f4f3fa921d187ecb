#include "pulse.hpp"

#include "noise_response.hpp"
#include "pulse_record.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::spectrum {

namespace {

constexpr double tolerated_change = 0.05;  // of the largest response, at half the amplitude

RoadSpectrum::Column column_of(const PulseRecord& full, const PulseRecord& half, std::size_t c,
                               const std::vector<double>& frequencies, double scale, const Start& start) {
  RoadSpectrum::Column column;
  const double beyond = full.beyond(c);
  for (const double f : frequencies) {
    if (!start.proceeds())
      throw Error("interrupted while the response to the pulse was computed", ExitStatus::interrupted);
    const std::complex<double> drive = full.drive_at(f), h = scale * full.column_at(c, f) / drive;
    column.response.push_back(h);
    column.error.push_back(scale * beyond / std::abs(drive));
    column.linearity.push_back(std::abs(h - scale * half.column_at(c, f) / half.drive_at(f)));
  }
  return column;
}

void note_tail(const PulseRecord& record, std::size_t c, const scenario::SpectrumPlan& plan,
               RoadSpectrum& road) {
  if (record.tail(c) < plan.decay) return;
  road.notes.push_back(fmt::format(
      "pulse: after {:.3g} s {} has not decayed: what follows changes the response by {}; give a longer longest_pulse",
      record.length(), plan.observed[c].name,
      std::isfinite(record.tail(c)) ? fmt::format("about {:.2g} of its largest value", record.tail(c))
                                    : "an unknown amount"));
}

void note_change(std::size_t c, const scenario::SpectrumPlan& plan, RoadSpectrum& road) {
  const RoadSpectrum::Column& column = road.columns[c];
  const double change = *std::max_element(column.linearity.begin(), column.linearity.end());
  double largest = 0;
  for (const std::complex<double>& h : column.response) largest = std::max(largest, std::abs(h));
  if (!(change > tolerated_change * largest)) return;
  road.notes.push_back(fmt::format(
      "pulse: at half the amplitude of {:g} m the response of {} changes by {:.2g} of its largest value, so that it is not linear; "
      "give a lower spectrum.amplitude",
      plan.amplitude, plan.observed[c].name, change / largest));
}

// The response of a packing that moves on its own is that of many states.
void note_motion(const PulseRecord& undriven, const PulseRecord& full, std::size_t c,
                 const scenario::SpectrumPlan& plan, RoadSpectrum& road) {
  if (!(undriven.largest(c) > full.largest(c))) return;
  road.notes.push_back(fmt::format(
      "pulse: without the pulse {} changes by {:.2g}, with it by {:.2g} more: the packing is not at rest; let it come to rest in a stage "
      "before (until), or give a larger spectrum.amplitude",
      plan.observed[c].name, undriven.largest(c), full.largest(c)));
}

// A record that ends before its pulse has no spectrum.
void check_length(const PulseRecord& record, const scenario::SpectrumPlan& plan) {
  if (plan.longest_pulse >= record.end_of_pulse()) return;
  throw Error(fmt::format(
      "{}: the record of {:g} s ends before the pulse of {:g} s; give a longer longest_pulse, or a smaller step_hz",
      plan.drive_place, plan.longest_pulse, record.end_of_pulse()));
}

void add_pulse_response(const PulseRecord& full, const PulseRecord& half, const Start& start,
                        RoadSpectrum& road) {
  const scenario::SpectrumPlan& plan = start.spectrum();
  for (std::size_t c = 0; c < plan.observed.size(); ++c) {
    const double scale = plan.observed[c].relative ? 1 / std::abs(full.at_start(c)) : 1;
    road.columns.push_back(column_of(full, half, c, road.frequencies, scale, start));
    if (!plan.observed[c].of_shape) note_tail(full, c, plan, road);
  }
}

}  // namespace

RoadSpectrum pulse_spectrum(const Start& start) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const scenario::SpectrumPlan& plan = start.spectrum();
  check_amplitude(start);
  const DrivenWalls walls(start);
  PulseRecord undriven(start, walls, 0, nullptr), full(start, walls, plan.amplitude, &undriven),
      half(start, walls, 0.5 * plan.amplitude, &undriven);
  check_length(full, plan);
  if (!full.until_decay() || !half.until_samples(full.samples()))
    throw Error("interrupted while the response to the pulse was recorded", ExitStatus::interrupted);
  RoadSpectrum road{.road = "pulse", .frequencies = plan.frequencies(), .columns = {}, .notes = {}};
  road.steps = undriven.steps() + full.steps() + half.steps();
  if (plan.pulse == scenario::SpectrumPlan::Pulse::noise)
    add_noise_response(full, half, plan, road);
  else
    add_pulse_response(full, half, start, road);
  for (std::size_t c = 0; c < plan.observed.size(); ++c)
    if (!plan.observed[c].of_shape) {
      note_motion(undriven, full, c, plan, road);
      note_change(c, plan, road);
    }
  road.note_silent(plan.observed);
  road.wall = std::chrono::duration<double>(Clock::now() - began).count();
  return road;
}

}  // namespace scree::spectrum
