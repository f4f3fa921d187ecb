#include "table/method_tables.hpp"

#include <fmt/format.h>

#include <scree/scenario/drive_sampling.hpp>
#include <scree/scenario/table_keys.hpp>

namespace scree::spectrum {

namespace {

using scenario::Range;
using Form = PulseSettings::Form;

const PulseSettings pulse_defaults;

struct PulseKeys : scenario::TableKeys {
  PulseKeys()
      : TableKeys("spectrum.pulse", "[spectrum.pulse]",
                  "the drive makes one pulse, which has all frequencies") {}
  scenario::ChoiceKey wave = choice_or_first(
      "wave", {"gaussian", "ricker", "chirp", "noise"},
      "a short pulse, as wide as to_hz needs; a chirp from from_hz to to_hz, which has more of each frequency for its "
      "amplitude; or noise over the band, by the seed of the scene, averaged over segments of 2 / step_hz");
  scenario::NumberKey samples_per_period =
      number("samples_per_period", Range::between(4, 1e4), pulse_defaults.samples_per_period,
             "of the observed columns, at to_hz");
  scenario::NumberKey decay = number(
      "decay", Range::between(1e-12, 0.5), pulse_defaults.decay,
      "integral of the response after the record over the integral in it, below which the response has decayed");
  scenario::NumberKey longest =
      number("longest", Range::positive("s"), "after which the record ends anyway; not of noise",
             "default 30 / step_hz");
  scenario::NumberKey chirp_duration =
      number("chirp_duration", Range::positive("s"), "in which the frequency of a chirp rises",
             "default 10 / from_hz");
  scenario::NumberKey noise_rms = number("noise_rms", Range::at_least(1e-100, "m"),
                                         "root mean square displacement of noise", "required for noise");
  scenario::NumberKey noise_duration =
      number("noise_duration", Range::positive("s"), "of noise and its record", "default 30 / step_hz");
};

const PulseKeys pulse_keys;

Form form_of(const std::string& wave) {
  return wave == "ricker"  ? Form::ricker
         : wave == "chirp" ? Form::chirp
         : wave == "noise" ? Form::noise
                           : Form::gaussian;
}

// A default that does not fit follows from a key of [spectrum]: the error is placed there.
Error error_at(const document::Table& spectrum, const document::Table& t, const scenario::Key& key,
               const std::string& problem, const std::string& cure) {
  return t.has(key) ? t.error(key, problem, cure) : spectrum.error("step_hz", problem, cure);
}

void check_chirp(const document::Table& spectrum, const document::Table& t, const SpectrumPlan& plan,
                 const PulseSettings& pulse) {
  if (pulse.chirp_duration * plan.to_hz < 1)
    throw t.error(
        pulse_keys.chirp_duration,
        fmt::format("a chirp of {:g} s has no period of to_hz = {:g} Hz", pulse.chirp_duration, plan.to_hz),
        "give a longer chirp_duration, such as 10 / from_hz");
  if (pulse.longest <= pulse.chirp_duration)
    throw error_at(spectrum, t, pulse_keys.longest,
                   fmt::format("the record of {:g} s ends before the chirp of {:g} s", pulse.longest,
                               pulse.chirp_duration),
                   "give a longer pulse.longest, or a shorter pulse.chirp_duration");
}

void check_noise(const document::Table& spectrum, const document::Table& t, const SpectrumPlan& plan,
                 double step, const PulseSettings& pulse) {
  constexpr double fewest_segments = 8, segment_steps = 2, most_noise_steps = 1e8,
                   margin = PulseSettings::band_margin;
  if (pulse.noise_duration * plan.step_hz < fewest_segments * segment_steps)
    throw t.error(pulse_keys.noise_duration,
                  fmt::format("noise of {:g} s has fewer than {:g} segments of {:g} s", pulse.noise_duration,
                              fewest_segments, segment_steps / plan.step_hz),
                  "give a longer noise_duration, or a larger step_hz");
  if (const auto problem = scenario::sampling_problem(plan.to_hz + margin * plan.from_hz, step))
    throw spectrum.error("to_hz",
                         fmt::format("noise has {:g} of from_hz more than the band: {}", margin, *problem),
                         "give a shorter time.step, or a lower to_hz");
  if (pulse.noise_duration > most_noise_steps * step)
    throw error_at(
        spectrum, t, pulse_keys.noise_duration,
        fmt::format("noise of {:g} s has more than {:g} steps", pulse.noise_duration, most_noise_steps),
        "give a shorter pulse.noise_duration");
}

}  // namespace

PulseSettings read_pulse(const document::Table& spectrum, const SpectrumPlan& plan, double step) {
  const document::Table t = spectrum.table_or_empty("pulse");
  PulseSettings pulse;
  pulse.form = form_of(read(t, pulse_keys.wave));
  pulse.samples_per_period = read(t, pulse_keys.samples_per_period);
  pulse.decay = read(t, pulse_keys.decay);
  pulse.longest = read_optional(t, pulse_keys.longest).value_or(30 / plan.step_hz);
  pulse.chirp_duration = read_optional(t, pulse_keys.chirp_duration).value_or(10 / plan.from_hz);
  pulse.noise_rms = pulse.form == Form::noise ? read(t, pulse_keys.noise_rms)
                                              : read_optional(t, pulse_keys.noise_rms).value_or(0);
  pulse.noise_duration = read_optional(t, pulse_keys.noise_duration).value_or(30 / plan.step_hz);
  if (pulse.form == Form::noise) check_noise(spectrum, t, plan, step, pulse);
  if (pulse.form == Form::chirp) check_chirp(spectrum, t, plan, pulse);
  return pulse;
}

const scenario::TableDescription& describe_pulse() { return pulse_keys.description(); }

}  // namespace scree::spectrum
