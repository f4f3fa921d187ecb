#include "output_keys.hpp"
#include "readers.hpp"
#include "scene_keys.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::scenario {

namespace {

constexpr const char* column_cure =
    "give the name of a [[probe]] and one of its columns, as \"stress.zz\" = { above = 1e3 }";

// Calls use(name, table) for each condition on a column: "stress.zz" = { }, or stress.zz = { } as TOML nests
// it.
template <class Use>
void for_each_column(const document::Table& until, const Use& use) {
  const auto is_other = [](const std::string& key) {
    const auto& known = until_keys.description().keys;
    return std::none_of(known.begin(), known.end(), [&](const auto& k) { return k.name == key; });
  };
  for (const std::string& key : until.keys()) {
    if (!is_other(key)) continue;
    if (key.find('.') != key.npos) {
      if (!until.is_table(key))
        throw until.error(key, fmt::format("'{}' is not a table", files::one_line(key)), column_cure);
      use(key, until.table(key));
    } else if (until.is_table(key)) {
      const document::Table nested = until.table(key);
      for (const auto& bound : until_column_keys.description().keys)
        if (nested.has(bound.name))
          throw until.error(key, fmt::format("'{}' is not a column of a probe", files::one_line(key)),
                            fmt::format("give one of its columns, as \"{}.<column>\"", files::one_line(key)));
      for (const std::string& column : nested.keys())
        if (nested.is_table(column)) use(key + "." + column, nested.table(column));
    }
  }
}

Condition read_column(const std::string& name, const document::Table& t) {
  Condition c;
  c.name = name;
  c.probe = 0;
  c.above = read_optional(t, until_column_keys.above);
  c.below = read_optional(t, until_column_keys.below);
  c.steady = read_optional(t, until_column_keys.steady);
  if (!c.above && !c.below && !c.steady) {
    t.optional(until_column_keys.over);
    t.refuse_unused();
    throw t.error(fmt::format("the condition on '{}' has no bound", files::one_line(name)),
                  "give above, below, or steady with over = <s>");
  }
  if (c.above && c.below && *c.above >= *c.below)
    throw t.error("above", fmt::format("above = {:g} is not less than below = {:g}", *c.above, *c.below),
                  "give a range that a number can be in");
  if (c.steady)
    c.over = read(t, until_column_keys.over);
  else if (t.has(until_column_keys.over))
    throw t.error(until_column_keys.over, "'over' is the time of 'steady', which is not given",
                  "add steady = <relative change>, or remove it");
  return c;
}

bool records_in(const ProbePlan& probe, std::size_t column, const std::string& stage) {
  const std::vector<std::string>& stages = probe.stages_of(column);
  return stages.empty() || std::find(stages.begin(), stages.end(), stage) != stages.end();
}

void find_column(const document::Table& until, const std::string& key, const std::vector<ProbePlan>& probes,
                 int dimension, const Stage& stage, Condition& c) {
  std::vector<std::string> names;
  for (const ProbePlan& probe : probes) names.push_back(probe.name);
  const std::size_t dot = c.name.find('.');
  if (names.empty())
    throw until.error(
        key, fmt::format("'{}' is a column of a probe, and the scene has none", files::one_line(c.name)),
        "add a [[probe]]");
  c.probe = find_name(until, key, "probe", c.name.substr(0, dot), names);
  const ProbePlan& probe = probes[c.probe];
  const ProbeColumns columns = columns_of(probe, dimension);
  c.column = find_name(until, key, "column", c.name.substr(dot + 1), columns.names);
  c.unit = columns.units[c.column] == "1" ? "" : columns.units[c.column];
  if (c.column == 0)
    throw until.error(key, "time is no condition of a stage", "give duration, at_least or at_most");
  --c.column;  // of the row, which has no time
  if (!records_in(probe, c.column, stage.name))
    throw until.error(key,
                      probe.stages_of_columns.empty()
                          ? fmt::format("the probe '{}' does not record in stage '{}'", probe.name,
                                        files::one_line(stage.name))
                          : fmt::format("a probe that '{}' reads does not record in stage '{}'", c.name,
                                        files::one_line(stage.name)),
                      "add the stage to its 'stages', or leave these out");
  if (c.steady && c.over < probe.every)
    throw until.error(key,
                      fmt::format("over = {:g} s is shorter than the {:g} s between samples of '{}'", c.over,
                                  probe.every, probe.name),
                      "give a longer time, or sample more often");
  const double at_most = *stage.until.at_most;
  if (c.steady && c.over >= at_most)
    throw until.error(
        key,
        fmt::format("over = {:g} s is not below at_most = {:g} s, so that it cannot be met", c.over, at_most),
        "give a shorter time, or a larger at_most");
  if (probe.every > at_most)
    throw until.error(key,
                      fmt::format("'{}' is sampled every {:g} s, which is more than at_most = {:g} s",
                                  probe.name, probe.every, at_most),
                      "sample more often, or give a larger at_most");
}

}  // namespace

Until read_until(const document::Table& t, double step) {
  Until until;
  if (const auto ratio = read_optional(t, until_keys.kinetic_over_elastic)) {
    Condition c;
    c.name = until_keys.kinetic_over_elastic.name;
    c.below = *ratio;
    until.conditions.push_back(c);
  }
  for_each_column(t, [&](const std::string& name, const document::Table& column) {
    const auto same = [&](const Condition& c) { return c.name == name; };
    if (std::any_of(until.conditions.begin(), until.conditions.end(), same))
      throw column.error(fmt::format("'{}' has two conditions", files::one_line(name)), "give one of them");
    until.conditions.push_back(read_column(name, column));
  });
  until.any = read(t, until_keys.match) == "any";
  until.at_least = read(t, until_keys.at_least);
  until.goes_on = read(t, until_keys.otherwise) == "go_on";
  if (until.conditions.empty()) {
    t.optional(until_keys.at_most);
    t.refuse_unused();
    throw t.error(
        "the stage has no condition",
        "give kinetic_over_elastic = 1e-6, or a column of a probe, as \"stress.zz\" = { above = 1e3 }");
  }
  until.at_most = read_steps(t, until_keys.at_most, step);
  if (until.at_least >= *until.at_most)
    throw t.error(
        "at_least",
        fmt::format("at_least = {:g} s is not below at_most = {:g} s", until.at_least, *until.at_most),
        "give a smaller at_least or a larger at_most");
  return until;
}

void find_conditions(const document::Table& root, const std::vector<ProbePlan>& probes, int dimension,
                     std::vector<Stage>& stages) {
  const std::vector<document::Table> tables = root.tables("stage");
  for (std::size_t k = 0; k < tables.size(); ++k)
    for (Condition& c : stages[k].until.conditions)
      if (c.probe != Condition::energies) {
        const document::Table until = tables[k].table(stage_keys.until);
        const std::string key = until.has(c.name) ? c.name : c.name.substr(0, c.name.find('.'));
        find_column(until, key, probes, dimension, stages[k], c);
      }
}

}  // namespace scree::scenario
