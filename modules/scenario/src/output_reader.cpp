#include "output_keys.hpp"
#include "readers.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/document/message.hpp>
#include <scree/files/text.hpp>
#include <scree/nearest.hpp>
#include <scree/pictures/render_options.hpp>
#include <scree/scenario/quantities.hpp>

namespace scree::scenario {

namespace {

Expectation read_expectation(const document::Table& t) {
  Expectation e;
  e.requirement = read(t, expect_keys.requirement);
  e.quantity = read(t, expect_keys.quantity);
  e.place = t.place(expect_keys.quantity);
  e.reference = read_optional(t, expect_keys.reference);
  e.tolerance = read_optional(t, expect_keys.tolerance);
  e.at_most = read_optional(t, expect_keys.at_most);
  e.at_least = read_optional(t, expect_keys.at_least);
  e.of_step = read(t, expect_keys.of_step);
  e.scale = read_optional(t, expect_keys.scale);
  if (e.reference.has_value() != e.tolerance.has_value())
    throw t.error(e.reference ? "reference" : "tolerance", "reference and tolerance must both be given",
                  "give both, or at_most / at_least");
  if (!e.reference && !e.at_most && !e.at_least)
    throw t.error("quantity", "the quantity has no required value",
                  "give reference and tolerance, at_most, or at_least");
  return e;
}

}  // namespace

std::vector<std::string> quantity_names(const std::vector<ProbePlan>& probes, int dimension) {
  std::vector<std::string> known = run_quantity_names();
  for (const ProbePlan& probe : probes)
    for (const std::string& column : columns_of(probe, dimension).names)
      for (const char* statistic : series_statistics)
        known.push_back(fmt::format("{}.{}.{}", probe.name, column, statistic));
  return known;
}

std::optional<std::string> quantity_problem(const std::string& name, const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return std::nullopt;
  const auto near = nearest_word(name, known);
  const std::string cure =
      near ? fmt::format("did you mean '{}'?", *near)
           : fmt::format("give one of {}, or <probe>.<column>.<{}>", fmt::join(run_quantity_names(), ", "),
                         fmt::join(series_statistics, "|"));
  return fmt::format("no quantity '{}'; {}", files::one_line(name), cure);
}

double read_interval(const document::Table& table, const Key& key, double step) {
  const double every = table.number(key, key.range);
  if (every < 0.999 * step)
    throw table.error(
        key, fmt::format("{} = {:g} s is shorter than the time step of {:g} s", key.name, every, step),
        "increase it, or decrease time.step");
  return every;
}

SnapshotPlan read_snapshot(const document::Table& root, double step) {
  SnapshotPlan plan;
  const auto t = root.optional_table("snapshot");
  if (!t) return plan;
  if (t->optional(snapshot_keys.every)) plan.every = read_interval(*t, snapshot_keys.every, step);
  if (t->optional(snapshot_keys.image_every))
    plan.image_every = read_interval(*t, snapshot_keys.image_every, step);
  plan.h5md = read(*t, snapshot_keys.h5md);
  if (plan.h5md && !plan.every)
    throw t->error(snapshot_keys.h5md, "a trajectory needs the time between its frames",
                   "give every = <s> too");
  plan.color_by = read(*t, snapshot_keys.color_by);
  if (t->optional(snapshot_keys.color_range)) {
    const std::vector<double> range = t->numbers(snapshot_keys.color_range, 2);
    if (range[0] >= range[1])
      throw t->error("color_range", fmt::format("{:g} is not below {:g}", range[0], range[1]),
                     "give the lower value first");
    plan.color_range = {range[0], range[1]};
  }
  plan.view = t->choice(snapshot_keys.view, snapshot_keys.view.words, "");
  plan.show_contacts = read(*t, snapshot_keys.contacts);
  plan.width = int(read(*t, snapshot_keys.width));
  plan.height = int(read(*t, snapshot_keys.height));
  return plan;
}

void read_expectations(const document::Table& root, const StudyTables* studies, Plan& plan) {
  const std::vector<std::string> known = quantity_names(plan.probes, plan.scene.dimension);
  const auto is_of_study = [&](const std::string& quantity) {
    return !studies || std::any_of(studies->begin(), studies->end(), [&](const StudyTable& study) {
      return study.judges(quantity) && root.has(study.name);
    });
  };
  for (const document::Table& t : root.tables("expect")) {
    Expectation e = read_expectation(t);
    const auto problem = quantity_problem(e.quantity, known);
    if (problem && !is_of_study(e.quantity)) throw Error(*problem).at(e.place);
    (problem ? plan.study_expectations : plan.expectations).push_back(std::move(e));
  }
}

}  // namespace scree::scenario
