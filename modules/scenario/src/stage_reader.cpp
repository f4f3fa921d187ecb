#include "readers.hpp"
#include "scene_keys.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/plugin/program.hpp>
#include <scree/scene_checks.hpp>
#include <scree/told_apart.hpp>

namespace scree::scenario {

namespace {

void check_steps(const document::Table& t, std::string_view key, double seconds, double step) {
  const double steps = seconds / step;
  if (steps < 0.999)
    throw t.error(key, fmt::format("{:g} s is shorter than the time step of {:g} s", seconds, step),
                  "increase it, or decrease time.step");
  const auto [shown, most] = told_apart(steps, most_steps, 3);
  if (steps > most_steps)
    throw t.error(key, fmt::format("{:g} s takes {} time steps of {:g} s", seconds, shown, step),
                  fmt::format("give a shorter time or a longer step, for at most {} steps", most));
}

void read_end(const document::Table& t, double step, Stage& stage) {
  const int given = int(t.optional(stage_keys.duration)) + int(t.optional(stage_keys.cycles)) +
                    int(t.optional(stage_keys.until));
  if (given != 1)
    throw t.error(given ? "the stage has more than one end condition" : "the stage has no end condition",
                  "give one of duration = <s>, cycles and period, or until = { kinetic_over_elastic = 1e-6, "
                  "at_most = <s> }");
  if (t.has(stage_keys.period) && !t.has(stage_keys.cycles))
    throw t.error("period", "'period' is the length of the 'cycles', which are not given",
                  "add cycles = <number> in place of the other end of the stage, or remove it");
  if (t.has(stage_keys.duration)) stage.duration = read_steps(t, stage_keys.duration, step);
  if (t.has(stage_keys.until)) stage.until = read_until(t.table(stage_keys.until), step);
  if (t.has(stage_keys.cycles)) {
    stage.period = read_steps(t, stage_keys.period, step);
    stage.duration = read(t, stage_keys.cycles) * stage.period;
    check_steps(t, "cycles", *stage.duration, step);
  }
}

// Warns of cycles that are no whole number of steps: samples once in a cycle drift in the phase of the load.
void warn_of_phases(const document::Table& t, double step, const Stage& stage,
                    std::vector<std::string>& warnings) {
  if (!(stage.period > 0) || !(*stage.duration > stage.period)) return;
  constexpr double round_off = 1e-6;  // steps
  const double steps = stage.period / step;
  if (std::abs(steps - std::round(steps)) <= round_off) return;
  warnings.push_back(
      t.error(
           "period",
           fmt::format(
               "a period of {:g} s is {:.10g} steps, so that samples once in a cycle are at another phase of the load in each",
               stage.period, steps),
           fmt::format("give time.step = {:.17g}", stage.period / std::ceil(steps)))
          .what());
}

// The functions of time of an instance that are given, by their keys; views of its parameters.
std::vector<std::pair<std::string, Program>> programs_of(const Parameters& parameters) {
  std::vector<std::pair<std::string, Program>> programs;
  const std::vector<scree_value> values = parameters.values();
  for (std::uint32_t k = 0; k < parameters.plugin().parameter_count; ++k)
    if (const scree_parameter& p = parameters.plugin().parameters[k];
        p.type == SCREE_PROGRAM && parameters.given(p.key))
      programs.emplace_back(p.key, Program(values[k]));
  return programs;
}

// Warns of loads whose period does not divide the cycle: each cycle ends at another phase. instances: as in
// the stage.
void warn_of_other_periods(const document::Table& t, const Scene& scene, const Stage& stage,
                           const std::vector<Stage::Change>& instances, std::vector<std::string>& warnings) {
  if (!(stage.period > 0)) return;
  constexpr double round_off = 1e-9;
  std::vector<std::string> others;
  for (const Stage::Change& instance : instances)
    for (const auto& [key, program] : programs_of(instance.parameters)) {
      const double period = program.period(), count = stage.period / period, whole = std::round(count);
      if (!(period > 0) || !has_effect(scene, instance.parameters, key)) continue;
      if (whole > 0 && std::abs(count - whole) <= round_off * count) continue;
      others.push_back(fmt::format("{}.{}, {:.10g} s", instance.name, key, period));
    }
  if (others.empty()) return;
  warnings.push_back(t.error("period",
                             fmt::format("cycles of {:.10g} s are no whole number of the periods of {}",
                                         stage.period, fmt::join(others, ", of ")),
                             "give cycles of a multiple of each period")
                         .what());
}

// Whether an instance follows one of its functions of time.
bool follows(const Stage::Change& instance, const std::string& key, const Scene& scene) {
  return instance.kind == SCREE_BOUNDARY ? has_effect(scene, instance.parameters, key)
                                         : !instance.parameters.absent();
}

// Keys of the functions of time that vary, that the instance has followed before a stage, and that the stage
// does not set: their time goes on.
std::vector<std::string> going_on(const Stage::Change& before, const document::Table& set,
                                  const Scene& scene) {
  std::vector<std::string> keys;
  for (const auto& [key, program] : programs_of(before.parameters))
    if (!set.has(key) && program.kind() != Program::constant && follows(before, key, scene))
      keys.push_back(key);
  return keys;
}

void read_changes(const document::Table& t, const Scene& scene, std::vector<Stage::Change>& instances,
                  Stage& stage) {
  const auto set = t.optional_table(stage_keys.set);
  if (!set) return;
  std::vector<std::string> names;
  for (const Stage::Change& instance : instances) names.push_back(instance.name);
  for (const std::string& name : set->keys()) {
    Stage::Change& instance = instances[find_name(*set, name, "law, boundary or body force", name, names)];
    const Stage::Change before = std::exchange(instance, changed_instance(set->table(name), instance, scene));
    instance.going_on = going_on(before, set->table(name), scene);
    stage.changes.push_back(instance);
  }
}

// Names a misspelt table, such as [[stages]] or [spectra], before the duration that is missing without it.
void refuse_unknown_tables(const document::Table& root, const StudyTables& studies) {
  for (const TableDescription& table : describe_tables(studies))
    if (table.name.find('.') == std::string::npos) root.accept(table.name);
  root.refuse_unused();
}

}  // namespace

double read_steps(const document::Table& table, const Key& key, double step) {
  const double seconds = table.number(key, key.range);
  check_steps(table, key, seconds, step);
  return seconds;
}

std::vector<Stage> read_stages(const document::Table& root, const Scene& scene, Instances instances,
                               const StudyTables* studies, std::vector<std::string>& warnings) {
  std::vector<Stage> stages;
  UniqueNames names("stage");
  const document::Table time = root.table("time");
  for (const document::Table& t : root.tables("stage")) {
    Stage stage;
    stage.name = t.string(stage_keys.name, fmt::format("stage {}", stages.size() + 1));
    names.add(t, stage.name);
    read_end(t, scene.step, stage);
    warn_of_phases(t, scene.step, stage, warnings);
    read_changes(t, scene, instances.all, stage);
    warn_of_other_periods(t, scene, stage, instances.all, warnings);
    stages.push_back(std::move(stage));
  }
  if (!stages.empty() && time.optional(time_keys.duration))
    throw time.error("duration", "both stages and time.duration are given",
                     "keep [[stage]] or time.duration");
  const auto has_table = [&](const StudyTable& study) { return root.has(study.name); };
  const bool needs_none =
      !time.has(time_keys.duration) && (!studies || std::any_of(studies->begin(), studies->end(), has_table));
  if (stages.empty() && !needs_none) {
    if (!time.has(time_keys.duration)) refuse_unknown_tables(root, *studies);
    Stage stage;
    stage.name = "run";
    stage.duration = read_steps(time, time_keys.duration, scene.step);
    stages.push_back(std::move(stage));
  }
  return stages;
}

}  // namespace scree::scenario
