#include "table/method_tables.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/files/text.hpp>
#include <scree/plugin/program.hpp>
#include <scree/probes.hpp>
#include <scree/scenario/drive_sampling.hpp>
#include <scree/scenario/names.hpp>
#include <scree/scenario/table_keys.hpp>
#include <scree/spectrum/peak_quantity.hpp>

namespace scree::spectrum {

namespace {

using scenario::find_name;
using scenario::Plan;
using scenario::Range;

constexpr const char* table_name = "spectrum";
constexpr double most_frequencies = 100000;

struct SpectrumKeys : scenario::TableKeys {
  SpectrumKeys()
      : TableKeys(
            table_name, "[spectrum]",
            "the response to a driven wall over frequency, for scree spectrum; stages, if any, run first") {}
  scenario::StringKey drive =
      string("drive", "boundary and its displacement, as \"top.displacement\", that takes the wave");
  scenario::NumberKey amplitude = number("amplitude", Range::at_least(1e-100, "m"),
                                         "largest displacement in a sweep or pulse; of noise see noise_rms");
  scenario::Key observe =
      other("observe", "[\"probe.column\", ...]", Range::any(), "required", "columns that respond");
  scenario::Key relative_to_mean =
      other("relative_to_mean", "[\"probe.column\", ...]", Range::any(), "default none",
            "columns that are divided by their means, such as the distance of two layers for a strain");
  scenario::StringKey shape_from =
      string("shape_from",
             "probe whose columns displacement_1, ... give the shapes and names of peaks, such as a profile",
             "default none, also \"\" and []");
  scenario::NumberKey from_hz = number("from_hz", Range::positive("Hz"), "lowest frequency");
  scenario::NumberKey to_hz = number("to_hz", Range::positive("Hz"), "highest frequency");
  scenario::NumberKey step_hz = number("step_hz", Range::positive("Hz"), "distance of frequencies");
};

const SpectrumKeys spectrum_keys;

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
  for (const scenario::ProbePlan& one : plan.probes) names.push_back(one.name);
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

// Whether a probe, or one whose columns it reads, observes the run.
bool observes_run(const Plan& plan, std::size_t probe) {
  const std::vector<scenario::ProbeInput>& inputs = plan.probes[probe].inputs;
  return Probe(plan.probes[probe].parameters, plan.scene.dimension).observes() ||
         std::any_of(inputs.begin(), inputs.end(),
                     [&](const scenario::ProbeInput& input) { return observes_run(plan, input.probe); });
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
    if (observes_run(plan, column.probe))
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
  if (const auto problem = scenario::sampling_problem(plan.to_hz, step))
    throw t.error(spectrum_keys.to_hz, *problem, "give a lower to_hz, or a shorter time.step");
  if ((plan.to_hz - plan.from_hz) / plan.step_hz > most_frequencies)
    throw t.error(spectrum_keys.step_hz,
                  fmt::format("{:g} frequencies are more than {:g}",
                              (plan.to_hz - plan.from_hz) / plan.step_hz, most_frequencies),
                  "give a larger step_hz");
}

// Keys of methods that stood in [spectrum] itself.
void refuse_former_keys(const document::Table& t) {
  constexpr std::pair<const char*, const char*> former[] = {
      {"direction", "sweep.direction"},
      {"periods", "sweep.periods"},
      {"analysed_periods", "sweep.analysed_periods"},
      {"samples_per_period", "sweep.samples_per_period and spectrum.pulse.samples_per_period"},
      {"rise_periods", "sweep.rise_periods"},
      {"detrend", "sweep.detrend"},
      {"adaptive", "sweep.adaptive and spectrum.linear.adaptive"},
      {"tolerance", "sweep.tolerance and spectrum.linear.tolerance"},
      {"chirp_duration", "pulse.chirp_duration"},
      {"decay", "pulse.decay"},
      {"longest_pulse", "pulse.longest, of noise spectrum.pulse.noise_duration"},
      {"fewest_contacts", "linear.fewest_contacts"},
      {"sliding_contacts", "linear.sliding_contacts"},
      {"linear_step", "linear.step"}};
  const auto refuse = [&](const char* key, const char* now) {
    throw t.error(key, fmt::format("spectrum.{} is now spectrum.{}", key, now), "write it there");
  };
  for (const auto& [key, now] : former)
    if (t.has(key)) refuse(key, now);
  if (t.has("pulse") && !t.is_table("pulse")) refuse("pulse", "pulse.wave");
}

// Expectations of peaks.
std::vector<scenario::Expectation> read_expectations(const Plan& plan,
                                                     const std::vector<ObservedColumn>& observed) {
  std::vector<scenario::Expectation> of_peaks;
  for (const scenario::Expectation& e : plan.study_expectations) {
    if (!names_peak(e.quantity)) continue;
    if (const auto problem = peak_quantity_problem(e.quantity, observed))
      throw Error(fmt::format("{}: {}", e.place, *problem));
    of_peaks.push_back(e);
  }
  return of_peaks;
}

std::vector<scenario::TableDescription> describe_spectrum() {
  return {spectrum_keys.description(), describe_sweep(), describe_pulse(), describe_linear()};
}

std::string check_spectrum(const Plan& plan) {
  const auto spectrum = read_spectrum(plan);
  if (!spectrum) return "";
  const std::vector<double> frequencies = spectrum->frequencies();
  double steps = 0;
  for (const double f : frequencies) steps += spectrum->sweep.periods / (f * plan.scene.step);
  if (spectrum->sweep.direction == SweepSettings::Direction::both) steps *= 2;
  return fmt::format("spectrum: {} from {:g} to {:g} Hz, {:.3g} steps for a sweep with all periods",
                     counted(frequencies.size(), "frequency", "frequencies"), frequencies.front(),
                     frequencies.back(), steps);
}

}  // namespace

std::vector<double> SpectrumPlan::frequencies() const {
  std::vector<double> all;
  const double steps = std::floor((to_hz - from_hz) / step_hz * (1 + 1e-12));
  for (double k = 0; k <= steps; ++k) all.push_back(from_hz + k * step_hz);
  return all;
}

std::optional<SpectrumPlan> read_spectrum(const Plan& plan) {
  if (!plan.document) return std::nullopt;
  const auto t = plan.document->root().optional_table(table_name);
  if (!t) return std::nullopt;
  refuse_former_keys(*t);
  SpectrumPlan spectrum;
  read_drive(*t, plan.scene, spectrum);
  spectrum.amplitude = read(*t, spectrum_keys.amplitude);
  read_observed(*t, plan, spectrum);
  read_shape(*t, plan, spectrum);
  read_frequencies(*t, plan.scene.step, spectrum);
  spectrum.sweep = read_sweep(*t, spectrum, plan.scene.step);
  spectrum.pulse = read_pulse(*t, spectrum, plan.scene.step);
  spectrum.linear = read_linear(*t);
  spectrum.expectations = read_expectations(plan, spectrum.observed);
  return spectrum;
}

scenario::StudyTable spectrum_table() { return {table_name, describe_spectrum, check_spectrum, names_peak}; }

}  // namespace scree::spectrum
