#include "stage_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include <scree/nearest.hpp>

#include "plugin_parameters.hpp"

namespace scree::scenario {

namespace {

void read_end(const Table& t, Stage& stage) {
  const Range time = Range::positive("s");
  const int given = int(t.has("duration")) + int(t.has("cycles")) + int(t.has("until"));
  if (given != 1)
    throw t.error(given ? "says more than once when it ends" : "does not say when it ends",
                  "give one of duration = <s>, cycles and period, or until = { kinetic_over_elastic = 1e-6 }");
  if (t.has("duration")) stage.duration = t.number("duration", time);
  if (t.has("cycles")) stage.duration = t.number("cycles", Range::positive()) * t.number("period", time);
  if (!t.has("until")) return;
  const Table until = t.table("until");
  stage.kinetic_over_elastic = until.number("kinetic_over_elastic", Range::positive());
  stage.at_least = until.number("at_least", 0.0, Range::non_negative("s"));
  stage.at_most = until.number("at_most", Range::positive("s"));
}

Stage::Change& instance_of(const Table& set, const std::string& name, std::vector<Stage::Change>& instances) {
  std::vector<std::string> names;
  for (Stage::Change& instance : instances) {
    if (instance.name == name) return instance;
    names.push_back(instance.name);
  }
  const auto near = nearest_word(name, names);
  throw set.error(name, fmt::format("nothing in the scene is named '{}'", name),
                  near ? fmt::format("did you mean '{}'?", *near) : fmt::format("there are: {}", fmt::join(names, ", ")));
}

void read_changes(const Table& t, int dimension, std::vector<Stage::Change>& instances, Stage& stage) {
  const auto set = t.optional_table("set");
  if (!set) return;
  for (const std::string& name : set->keys()) {
    Stage::Change& instance = instance_of(*set, name, instances);
    const Table values = set->table(name);
    read_parameters(values, dimension, instance.parameters);
    check_complete(values, instance.parameters);
    stage.changes.push_back(instance);
  }
}

}  // namespace

std::vector<Stage> read_stages(const Table& root, const Scene& scene, std::vector<Stage::Change> instances) {
  std::vector<Stage> stages;
  std::set<std::string> names;
  const Table time = root.table("time");
  for (const Table& t : root.tables("stage")) {
    Stage stage;
    stage.name = t.string("name", fmt::format("stage {}", stages.size() + 1));
    if (!names.insert(stage.name).second)
      throw t.error("name", fmt::format("the stage name '{}' is taken", stage.name), "use another name");
    read_end(t, stage);
    read_changes(t, scene.dimension, instances, stage);
    stages.push_back(std::move(stage));
  }
  if (!stages.empty() && time.has("duration"))
    throw time.error("duration", "the run has both stages and a duration", "keep [[stage]] or time.duration");
  if (stages.empty()) {
    Stage stage;
    stage.name = "run";
    stage.duration = time.number("duration", Range::positive("s"));
    stages.push_back(std::move(stage));
  }
  return stages;
}

}  // namespace scree::scenario
