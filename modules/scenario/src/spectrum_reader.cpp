#include "spectrum_reader.hpp"

#include "names.hpp"
#include "spectrum_keys.hpp"
#include "stage_reader.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/document/message.hpp>
#include <scree/files/text.hpp>
#include <scree/plugin/program.hpp>
#include <scree/probes.hpp>

namespace scree::scenario {

namespace {

constexpr double most_frequencies = 100000;

// The keys of a boundary that are functions of time in m.
std::vector<std::string> displacements_of(const Parameters& boundary) {
  std::vector<std::string> keys;
  for (std::uint32_t k = 0; k < boundary.plugin().parameter_count; ++k) {
    const scree_parameter& p = boundary.plugin().parameters[k];
    if (p.type == SCREE_PROGRAM && std::string(p.unit) == "m") keys.push_back(p.key);
  }
  return keys;
}

// The clock of a boundary starts again at each frequency, so that nothing else of it may vary.
void check_others(const document::Table& t, const Parameters& boundary, const std::string& drive) {
  const std::vector<scree_value> values = boundary.values();
  for (std::uint32_t k = 0; k < boundary.plugin().parameter_count; ++k) {
    const scree_parameter& p = boundary.plugin().parameters[k];
    if (p.type != SCREE_PROGRAM || !boundary.given(p.key) || p.key == drive) continue;
    if (Program(values[k]).kind() != Program::constant)
      throw t.error(
          spectrum_keys.drive,
          fmt::format(
              "'{}' of the driven boundary varies with time, and would start again at every frequency",
              p.key),
          "give it a constant, or drive another boundary");
  }
}

void read_drive(const document::Table& t, const Scene& scene, SpectrumPlan& plan) {
  const std::string drive = read(t, spectrum_keys.drive);
  plan.drive_place = t.place(spectrum_keys.drive);
  const auto dot = drive.rfind('.');
  if (dot == std::string::npos)
    throw t.error(spectrum_keys.drive, fmt::format("'{}' names no key of a boundary", files::one_line(drive)),
                  "give \"<boundary>.<key>\", such as \"top.displacement\"");
  plan.boundary = drive.substr(0, dot), plan.key = drive.substr(dot + 1);
  std::vector<std::string> names;
  for (const Scene::Boundary& boundary : scene.boundaries) names.push_back(boundary.name);
  const Parameters& boundary =
      scene.boundaries[find_name(t, spectrum_keys.drive, "boundary", plan.boundary, names)].parameters;
  const std::vector<std::string> keys = displacements_of(boundary);
  find_name(t, spectrum_keys.drive, fmt::format("displacement of '{}' named", plan.boundary), plan.key, keys);
  check_others(t, boundary, plan.key);
}

// All columns of all probes, with nothing but where and what they are.
std::vector<ObservedColumn> all_columns(const Plan& plan) {
  std::vector<ObservedColumn> all;
  for (std::size_t p = 0; p < plan.probes.size(); ++p) {
    const Probe probe(plan.probes[p].parameters, plan.scene.dimension);
    const std::vector<std::string> names = probe.names(), units = probe.units();
    for (std::size_t c = 0; c < names.size(); ++c)
      all.push_back({p, c, fmt::format("{}.{}", plan.probes[p].name, names[c]), units[c], false, "", false});
  }
  return all;
}

// Whether an override has emptied a key, so that it holds nothing: "" or [].
bool is_empty(const document::Table& t, std::string_view key) {
  return t.is_array(key) ? t.toml_elements(key).empty() : t.is_string(key) && t.string(key).empty();
}

// Columns displacement_1, displacement_2, ... of a probe, in their order.
void read_shape(const document::Table& t, const Plan& plan, SpectrumPlan& spectrum) {
  if (!t.optional(spectrum_keys.shape_from) || is_empty(t, spectrum_keys.shape_from)) return;
  const std::string probe = read(t, spectrum_keys.shape_from);
  constexpr std::size_t fewest_layers = 3;
  std::vector<std::string> names;
  for (const ProbePlan& one : plan.probes) names.push_back(one.name);
  const std::size_t number = find_name(t, spectrum_keys.shape_from, "probe", probe, names);
  std::size_t layers = 0;
  for (ObservedColumn& column : all_columns(plan)) {
    if (column.probe != number || !column.name.starts_with(probe + ".displacement_")) continue;
    column.of_shape = true;
    column.place = t.place(spectrum_keys.shape_from);
    spectrum.observed.push_back(std::move(column));
    ++layers;
  }
  if (layers < fewest_layers)
    throw t.error(
        spectrum_keys.shape_from,
        fmt::format("'{}' has {} displacement_<n>", files::one_line(probe), counted(layers, "column")),
        "give a probe such as profile, with three bins or more");
}

void read_observed(const document::Table& t, const Plan& plan, SpectrumPlan& spectrum) {
  const std::vector<ObservedColumn> all = all_columns(plan);
  std::vector<std::string> names, observed;
  for (const ObservedColumn& column : all) names.push_back(column.name);
  const std::vector<std::string> asked = t.strings(spectrum_keys.observe);
  if (asked.empty())
    throw t.error(spectrum_keys.observe, "'observe' has no columns",
                  "give columns of probes, such as [\"strain.strain\"]");
  for (std::size_t k = 0; k < asked.size(); ++k) {
    ObservedColumn column = all[find_name(t, spectrum_keys.observe, "column", asked[k], names, k)];
    column.place = t.place(spectrum_keys.observe, k);
    if (std::find(observed.begin(), observed.end(), column.name) != observed.end())
      throw t.error(spectrum_keys.observe, k, fmt::format("'{}' stands here twice", column.name),
                    "remove one");
    if (Probe(plan.probes[column.probe].parameters, plan.scene.dimension).observes())
      throw t.error(spectrum_keys.observe, k,
                    fmt::format("'{}' depends on all steps, not on the present state", column.name),
                    "observe a column of a probe such as strain, layer or particles");
    observed.push_back(column.name);
    spectrum.observed.push_back(std::move(column));
  }
  if (!t.optional(spectrum_keys.relative_to_mean)) return;
  const std::vector<std::string> relative = t.strings(spectrum_keys.relative_to_mean);
  for (std::size_t k = 0; k < relative.size(); ++k)
    spectrum
        .observed[find_name(t, spectrum_keys.relative_to_mean, "observed column", relative[k], observed, k)]
        .relative = true;
}

void read_frequencies(const document::Table& t, double step, SpectrumPlan& plan) {
  plan.from_hz = read(t, spectrum_keys.from_hz);
  plan.to_hz = read(t, spectrum_keys.to_hz);
  plan.step_hz = read(t, spectrum_keys.step_hz);
  if (!(plan.from_hz < plan.to_hz))
    throw t.error(spectrum_keys.from_hz,
                  fmt::format("{:g} Hz is not below to_hz = {:g} Hz", plan.from_hz, plan.to_hz),
                  "give the lower frequency first; direction says how a sweep goes");
  if (const auto problem = sampling_problem(plan.to_hz, step))
    throw t.error(spectrum_keys.to_hz, *problem, "give a lower to_hz, or a shorter time.step");
  if ((plan.to_hz - plan.from_hz) / plan.step_hz > most_frequencies)
    throw t.error(spectrum_keys.step_hz,
                  fmt::format("{:g} frequencies are more than {:g}",
                              (plan.to_hz - plan.from_hz) / plan.step_hz, most_frequencies),
                  "give a larger step_hz");
}

void read_sweep(const document::Table& t, double step, SpectrumPlan& plan) {
  const std::string direction = read(t, spectrum_keys.direction);
  plan.direction = direction == "up"     ? SpectrumPlan::Direction::up
                   : direction == "down" ? SpectrumPlan::Direction::down
                                         : SpectrumPlan::Direction::both;
  plan.periods = read(t, spectrum_keys.periods);
  plan.analysed_periods = read(t, spectrum_keys.analysed_periods);
  if (const double steps = plan.periods / (plan.from_hz * step); !(steps <= most_steps))
    throw t.error(
        spectrum_keys.from_hz,
        fmt::format("{:g} periods of {:g} Hz take {:.3g} time steps", plan.periods, plan.from_hz, steps),
        fmt::format("give a higher from_hz, or fewer periods, for at most {:g} steps", most_steps));
  if (plan.analysed_periods > plan.periods)
    throw t.error(
        t.has(spectrum_keys.analysed_periods) ? spectrum_keys.analysed_periods : spectrum_keys.periods,
        fmt::format("{:g} analysed periods are more than the {:g} at each frequency", plan.analysed_periods,
                    plan.periods),
        "give fewer analysed_periods, or more periods");
  plan.samples_per_period = read(t, spectrum_keys.samples_per_period);
  plan.rise_periods = read(t, spectrum_keys.rise_periods);
  if (plan.rise_periods > plan.periods - plan.analysed_periods)
    throw t.error(spectrum_keys.rise_periods,
                  fmt::format("a rise of {:g} periods reaches into the analysed ones, which begin after {:g}",
                              plan.rise_periods, plan.periods - plan.analysed_periods),
                  "give fewer rise_periods or analysed_periods, or more periods");
  plan.detrending = read(t, spectrum_keys.detrend) == "polynomial" ? SpectrumPlan::Detrending::polynomial
                                                                   : SpectrumPlan::Detrending::period_average;
}

void read_adaptive(const document::Table& t, SpectrumPlan& plan) {
  plan.adaptive = read(t, spectrum_keys.adaptive);
  plan.tolerance = read(t, spectrum_keys.tolerance);
  if (plan.adaptive && plan.direction == SpectrumPlan::Direction::both)
    throw t.error(spectrum_keys.adaptive, "an adaptive sweep takes each frequency once",
                  "give direction = \"up\" or \"down\"");
}

void check_noise(const document::Table& t, double step, const SpectrumPlan& plan) {
  constexpr double fewest_segments = 8, segment_steps = 2, most_steps = 1e8;
  if (plan.longest_pulse * plan.step_hz < fewest_segments * segment_steps)
    throw t.error(spectrum_keys.longest_pulse,
                  fmt::format("noise of {:g} s has fewer than {:g} segments of {:g} s", plan.longest_pulse,
                              fewest_segments, segment_steps / plan.step_hz),
                  "give a longer longest_pulse, or a larger step_hz");
  if (const auto problem = sampling_problem(plan.to_hz + SpectrumPlan::band_margin * plan.from_hz, step))
    throw t.error(
        spectrum_keys.to_hz,
        fmt::format("noise has {:g} of from_hz more than the band: {}", SpectrumPlan::band_margin, *problem),
        "give a shorter time.step, or a lower to_hz");
  if (plan.longest_pulse > most_steps * step)
    throw t.error(t.has(spectrum_keys.longest_pulse) ? spectrum_keys.longest_pulse : spectrum_keys.step_hz,
                  fmt::format("noise of {:g} s has more than {:g} steps", plan.longest_pulse, most_steps),
                  "give a shorter longest_pulse");
}

void read_pulse(const document::Table& t, double step, SpectrumPlan& plan) {
  const std::string pulse = read(t, spectrum_keys.pulse);
  plan.pulse = pulse == "ricker"  ? SpectrumPlan::Pulse::ricker
               : pulse == "chirp" ? SpectrumPlan::Pulse::chirp
               : pulse == "noise" ? SpectrumPlan::Pulse::noise
                                  : SpectrumPlan::Pulse::gaussian;
  plan.chirp_duration = read_optional(t, spectrum_keys.chirp_duration).value_or(10 / plan.from_hz);
  if (plan.pulse == SpectrumPlan::Pulse::chirp && plan.chirp_duration * plan.to_hz < 1)
    throw t.error(
        spectrum_keys.chirp_duration,
        fmt::format("a chirp of {:g} s has no period of to_hz = {:g} Hz", plan.chirp_duration, plan.to_hz),
        "give a longer chirp_duration, such as 10 / from_hz");
  plan.decay = read(t, spectrum_keys.decay);
  plan.longest_pulse = read_optional(t, spectrum_keys.longest_pulse).value_or(30 / plan.step_hz);
  if (plan.pulse == SpectrumPlan::Pulse::chirp && plan.longest_pulse <= plan.chirp_duration)
    throw t.error(t.has(spectrum_keys.longest_pulse) ? spectrum_keys.longest_pulse : spectrum_keys.step_hz,
                  fmt::format("the record of {:g} s ends before the chirp of {:g} s", plan.longest_pulse,
                              plan.chirp_duration),
                  "give a longer longest_pulse, or a shorter chirp_duration");
  if (plan.pulse == SpectrumPlan::Pulse::noise) check_noise(t, step, plan);
  plan.fewest_contacts =
      int(t.optional_integer(spectrum_keys.fewest_contacts, spectrum_keys.fewest_contacts.range).value_or(0));
  plan.contacts_slide = read(t, spectrum_keys.sliding_contacts) == "slide";
  plan.step_of_run = read(t, spectrum_keys.linear_step) == "run";
}

}  // namespace

std::vector<double> SpectrumPlan::frequencies() const {
  std::vector<double> all;
  const double steps = std::floor((to_hz - from_hz) / step_hz * (1 + 1e-12));
  for (double k = 0; k <= steps; ++k) all.push_back(from_hz + k * step_hz);
  return all;
}

std::optional<std::string> sampling_problem(double to_hz, double step) {
  if (to_hz * step < 0.5) return std::nullopt;
  return fmt::format("{:g} Hz is not below half the sampling rate of a sample per step, {:g} Hz", to_hz,
                     0.5 / step);
}

std::optional<SpectrumPlan> read_spectrum(const document::Table& root, const Plan& plan) {
  const auto t = root.optional_table("spectrum");
  if (!t) return std::nullopt;
  SpectrumPlan spectrum;
  read_drive(*t, plan.scene, spectrum);
  spectrum.amplitude = read(*t, spectrum_keys.amplitude);
  read_observed(*t, plan, spectrum);
  read_shape(*t, plan, spectrum);
  read_frequencies(*t, plan.scene.step, spectrum);
  read_sweep(*t, plan.scene.step, spectrum);
  read_adaptive(*t, spectrum);
  read_pulse(*t, plan.scene.step, spectrum);
  return spectrum;
}

}  // namespace scree::scenario
