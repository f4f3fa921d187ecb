#include "output_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <scree/nearest.hpp>
#include <scree/probes.hpp>
#include <scree/scenario/run_quantities.hpp>

#include "plugin_parameters.hpp"

namespace scree::scenario {

namespace {

// The word itself if it is among the candidates; else an Error at the key that suggests the nearest.
const std::string& one_of(const Table& t, std::string_view key, const std::string& word, const char* what,
                          const std::vector<std::string>& candidates) {
  if (std::find(candidates.begin(), candidates.end(), word) != candidates.end()) return word;
  const auto near = nearest_word(word, candidates);
  throw t.error(key, fmt::format("no {} '{}'", what, word),
                near ? fmt::format("did you mean '{}'?", *near)
                     : fmt::format("there are: {}", candidates.empty() ? "none" : fmt::format("{}", fmt::join(candidates, ", "))));
}

const ProbePlan& probe_named(const Table& t, std::string_view key, const std::string& name,
                             const std::vector<ProbePlan>& probes) {
  std::vector<std::string> names;
  for (const ProbePlan& probe : probes) names.push_back(probe.name);
  one_of(t, key, name, "probe", names);
  return *std::find_if(probes.begin(), probes.end(), [&](const ProbePlan& p) { return p.name == name; });
}

struct Columns {
  std::vector<std::string> names, units;
};

Columns columns_of(const ProbePlan& probe, int dimension) {
  const Probe configured(probe.parameters, dimension);
  Columns columns = {configured.names(), configured.units()};
  columns.names.insert(columns.names.begin(), "time");
  columns.units.insert(columns.units.begin(), "s");
  return columns;
}

// "deviatoric strain" or "length x (m)".
std::string label_of(const Columns& columns, const std::string& name) {
  const auto at = std::size_t(std::find(columns.names.begin(), columns.names.end(), name) - columns.names.begin());
  std::string label = name;
  std::replace(label.begin(), label.end(), '_', ' ');
  return columns.units[at].empty() ? label : fmt::format("{} ({})", label, columns.units[at]);
}

ChartPlan read_chart(const Table& t, const std::vector<ProbePlan>& probes, int dimension) {
  ChartPlan chart;
  chart.name = t.string("name");
  const ProbePlan& probe = probe_named(t, "probe", t.string("probe"), probes);
  const Columns columns = columns_of(probe, dimension);
  const std::string x = t.string("x", "time");
  one_of(t, "x", x, "column", columns.names);
  const std::vector<std::string> ys = t.is_array("y") ? t.strings("y") : std::vector<std::string>{t.string("y")};
  for (const std::string& y : ys) {
    one_of(t, "y", y, "column", columns.names);
    std::string name = y;
    std::replace(name.begin(), name.end(), '_', ' ');
    chart.curves.push_back({name, probe.name, x, y});
  }
  if (ys.empty()) throw t.error("y", "names no column", "give one or more of the probe's columns");
  chart.title = t.string("title", chart.name);
  chart.x_label = t.string("x_label", label_of(columns, x));
  chart.y_label = t.string("y_label", label_of(columns, ys[0]));
  chart.log_x = t.boolean("log_x", false);
  chart.log_y = t.boolean("log_y", false);
  return chart;
}

}  // namespace

std::vector<ProbePlan> read_probes(const Table& root, const Scene& scene, const std::vector<Stage>& stages,
                                   PluginHost& host) {
  std::vector<ProbePlan> probes;
  std::set<std::string> taken;
  std::vector<std::string> stage_names;
  for (const Stage& stage : stages) stage_names.push_back(stage.name);
  for (const Table& t : root.tables("probe")) {
    ProbePlan probe{"", Parameters(find_plugin(t, SCREE_PROBE, host)), 0, {}};
    read_parameters(t, scene.dimension, probe.parameters);
    check_complete(t, probe.parameters);
    probe.name = t.string("name", probe.parameters.plugin().name);
    if (!taken.insert(probe.name).second)
      throw t.error("name", fmt::format("the probe name '{}' is taken", probe.name), "give this probe a name of its own");
    if (probe.name.empty() || probe.name.find_first_of("/\\.") != std::string::npos)
      throw t.error("name", fmt::format("'{}' cannot be a file name", probe.name), "use letters, digits, '_' and '-'");
    probe.every = t.number("every", Range::positive("s"));
    if (t.has("stages")) probe.stages = t.strings("stages");
    for (const std::string& stage : probe.stages) one_of(t, "stages", stage, "stage", stage_names);
    placed(t, "plugin", [&] { Probe(probe.parameters, scene.dimension); });
    probes.push_back(std::move(probe));
  }
  return probes;
}

SnapshotPlan read_snapshot(const Table& root) {
  SnapshotPlan plan;
  const auto t = root.optional_table("snapshot");
  if (!t) return plan;
  plan.every = t->optional_number("every", Range::positive("s"));
  plan.image_every = t->optional_number("image_every", Range::positive("s"));
  plan.color_by = t->choice("color_by", {"radius", "speed", "spin", "coordination", "force", "id"}, "radius");
  plan.view = t->choice("view", {"iso", "x", "y", "z", ""}, "");
  plan.show_contacts = t->boolean("contacts", false);
  plan.width = int(t->integer("width", 1200, Range::between(200, 8000, "pixels")));
  plan.height = int(t->integer("height", 900, Range::between(200, 8000, "pixels")));
  return plan;
}

std::vector<ChartPlan> read_charts(const Table& root, const std::vector<ProbePlan>& probes, int dimension) {
  std::vector<ChartPlan> charts;
  std::set<std::string> names;
  for (const Table& t : root.tables("chart")) {
    charts.push_back(read_chart(t, probes, dimension));
    const std::string& name = charts.back().name;
    if (name.empty() || name.find_first_of("/\\") != std::string::npos || !names.insert(name).second)
      throw t.error("name", fmt::format("'{}' is taken or cannot be a file name", name), "use letters, digits, '_' and '-'");
  }
  return charts;
}

std::vector<Expectation> read_expectations(const Table& root, const std::vector<ProbePlan>& probes, int dimension) {
  std::vector<Expectation> all;
  for (const Table& t : root.tables("expect")) {
    Expectation e;
    e.requirement = t.string("requirement");
    e.quantity = t.string("quantity");
    e.reference = t.optional_number("reference");
    e.tolerance = t.optional_number("tolerance", Range::non_negative());
    e.at_most = t.optional_number("at_most");
    e.at_least = t.optional_number("at_least");
    if (e.reference.has_value() != e.tolerance.has_value())
      throw t.error("reference", "reference and tolerance go together", "give both, or at_most / at_least");
    if (!e.reference && !e.at_most && !e.at_least)
      throw t.error("quantity", "nothing is said of what the quantity must be", "give reference and tolerance, at_most, or at_least");
    std::vector<std::string> known = run_quantity_names();
    for (const ProbePlan& probe : probes)
      for (const std::string& column : columns_of(probe, dimension).names)
        for (const char* statistic : series_statistics) known.push_back(fmt::format("{}.{}.{}", probe.name, column, statistic));
    if (std::find(known.begin(), known.end(), e.quantity) == known.end()) {
      const auto near = nearest_word(e.quantity, known);
      throw t.error("quantity", fmt::format("no quantity '{}'", e.quantity),
                    near ? fmt::format("did you mean '{}'?", *near)
                         : fmt::format("give one of {}, or <probe>.<column>.<{}>", fmt::join(run_quantity_names(), ", "), fmt::join(series_statistics, "|")));
    }
    all.push_back(std::move(e));
  }
  return all;
}

}  // namespace scree::scenario
