#include "stage_reader.hpp"

#include "plugin_parameters.hpp"

#include <fmt/format.h>

namespace scree::scenario {

namespace {

// At one microsecond per step, faster than almost any scene, this takes twelve days.
constexpr double max_steps = 1e12;

void check_steps(const document::Table& t, std::string_view key, double seconds, double step) {
  const double steps = seconds / step;
  if (steps < 0.999)
    throw t.error(key, fmt::format("{:g} s is shorter than the time step of {:g} s", seconds, step),
                  "increase it, or decrease time.step");
  if (steps > max_steps)
    throw t.error(key, fmt::format("{:g} s takes {:.3g} time steps of {:g} s", seconds, steps, step),
                  fmt::format("give a shorter time or a longer step, for at most {:g} steps", max_steps));
}

void read_condition(const document::Table& until, double step, Stage& stage) {
  stage.kinetic_over_elastic = until.number("kinetic_over_elastic", document::Range::positive());
  stage.at_least = until.number("at_least", 0.0, document::Range::non_negative("s"));
  stage.at_most = read_steps(until, "at_most", step);
  if (stage.at_least >= *stage.at_most)
    throw until.error(
        "at_least",
        fmt::format("at_least = {:g} s is not below at_most = {:g} s", stage.at_least, *stage.at_most),
        "give a smaller at_least or a larger at_most");
}

void read_end(const document::Table& t, double step, Stage& stage) {
  const int given = int(t.has("duration")) + int(t.has("cycles")) + int(t.has("until"));
  if (given != 1)
    throw t.error(given ? "the stage has more than one end condition" : "the stage has no end condition",
                  "give one of duration = <s>, cycles and period, or until = { kinetic_over_elastic = 1e-6, "
                  "at_most = <s> }");
  if (t.has("duration")) stage.duration = read_steps(t, "duration", step);
  if (t.has("until")) read_condition(t.table("until"), step, stage);
  if (t.has("cycles")) {
    const double period = read_steps(t, "period", step);
    stage.duration = t.number("cycles", document::Range::positive()) * period;
    check_steps(t, "cycles", *stage.duration, step);
  }
}

void read_changes(const document::Table& t, const Scene& scene, std::vector<Stage::Change>& instances,
                  Stage& stage) {
  const auto set = t.optional_table("set");
  if (!set) return;
  std::vector<std::string> names;
  for (const Stage::Change& instance : instances) names.push_back(instance.name);
  for (const std::string& name : set->keys()) {
    Stage::Change& instance = instances[find_name(*set, name, "law, boundary or body force", name, names)];
    instance = changed_instance(set->table(name), instance, scene);
    stage.changes.push_back(instance);
  }
}

}  // namespace

double read_steps(const document::Table& table, std::string_view key, double step) {
  const double seconds = table.number(key, document::Range::positive("s"));
  check_steps(table, key, seconds, step);
  return seconds;
}

std::vector<Stage> read_stages(const document::Table& root, const Scene& scene, Instances instances) {
  std::vector<Stage> stages;
  UniqueNames names("stage");
  const document::Table time = root.table("time");
  for (const document::Table& t : root.tables("stage")) {
    Stage stage;
    stage.name = t.string("name", fmt::format("stage {}", stages.size() + 1));
    names.add(t, stage.name);
    read_end(t, scene.step, stage);
    read_changes(t, scene, instances.all, stage);
    stages.push_back(std::move(stage));
  }
  if (!stages.empty() && time.has("duration"))
    throw time.error("duration", "both stages and time.duration are given",
                     "keep [[stage]] or time.duration");
  if (stages.empty()) {
    Stage stage;
    stage.name = "run";
    stage.duration = read_steps(time, "duration", scene.step);
    stages.push_back(std::move(stage));
  }
  return stages;
}

}  // namespace scree::scenario
