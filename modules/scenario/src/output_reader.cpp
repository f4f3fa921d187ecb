#include "output_reader.hpp"

#include "interval.hpp"
#include "names.hpp"
#include "output_keys.hpp"
#include "probe_reader.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/document/message.hpp>
#include <scree/files/text.hpp>
#include <scree/nearest.hpp>
#include <scree/scenario/peak_quantity.hpp>
#include <scree/scenario/quantities.hpp>
#include <scree/snapshot/render_options.hpp>

namespace scree::scenario {

namespace {

const ProbePlan& probe_named(const document::Table& t, const std::vector<ProbePlan>& probes) {
  std::vector<std::string> names;
  for (const ProbePlan& probe : probes) names.push_back(probe.name);
  return probes[find_name(t, "probe", "probe", read(t, chart_keys.probe), names)];
}

std::string as_words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

// The label and unit of an axis; the user's own label is complete.
void set_axis(const document::Table& t, const StringKey& key, const std::string& words,
              const std::string& column_unit, std::string& label, std::string& unit) {
  const bool own = t.optional(key);
  label = own ? t.string(key) : words;
  unit = own ? "" : column_unit;
}

// Curves of the given columns; their common unit, or none if it differs: then their names have it.
std::string add_curves(const ProbeColumns& columns, const std::vector<std::size_t>& at, const std::string& x,
                       ChartPlan& chart, const std::string& probe) {
  const auto unit = [&](std::size_t k) { return columns.units[at[k]]; };
  bool same = true;
  for (std::size_t k = 1; k < at.size(); ++k) same &= unit(k) == unit(0);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const std::string words = as_words(columns.names[at[k]]);
    const std::string name = same || unit(k).empty() ? words : fmt::format("{} ({})", words, unit(k));
    chart.curves.push_back({name, probe, x, columns.names[at[k]]});
  }
  return same ? unit(0) : "";
}

ChartPlan read_chart(const document::Table& t, const std::vector<ProbePlan>& probes, int dimension) {
  ChartPlan chart;
  chart.name = read(t, chart_keys.name);
  check_file_name(t, chart.name);
  const ProbePlan& probe = probe_named(t, probes);
  const ProbeColumns columns = columns_of(probe, dimension);
  const std::string x = read(t, chart_keys.x);
  const std::size_t x_at = find_name(t, "x", "column", x, columns.names);
  const bool several = t.is_array(chart_keys.y);
  const std::vector<std::string> ys = several ? t.strings(chart_keys.y) : std::vector{t.string(chart_keys.y)};
  if (ys.empty()) throw t.error("y", "'y' has no columns", "give one or more columns of the probe");
  std::vector<std::size_t> at;
  for (std::size_t k = 0; k < ys.size(); ++k)
    at.push_back(find_name(t, "y", "column", ys[k], columns.names, k));
  const std::string y_unit = add_curves(columns, at, x, chart, probe.name);
  chart.title = t.string(chart_keys.title, chart.name);
  set_axis(t, chart_keys.x_label, as_words(x), columns.units[x_at], chart.x_label, chart.x_unit);
  // With several curves the axis has only the unit; the legend has the names.
  set_axis(t, chart_keys.y_label, ys.size() == 1 ? as_words(ys[0]) : "", y_unit, chart.y_label, chart.y_unit);
  chart.log_x = read(t, chart_keys.log_x);
  chart.log_y = read(t, chart_keys.log_y);
  return chart;
}

Expectation read_expectation(const document::Table& t) {
  Expectation e;
  e.requirement = read(t, expect_keys.requirement);
  e.quantity = read(t, expect_keys.quantity);
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

std::optional<std::string> quantity_problem(const std::string& name, const std::vector<std::string>& known,
                                            const std::optional<SpectrumPlan>& spectrum) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return std::nullopt;
  if (names_peak(name) && spectrum) return peak_quantity_problem(name, spectrum->observed);
  const auto near = nearest_word(name, known);
  const std::string cure =
      near ? fmt::format("did you mean '{}'?", *near)
           : fmt::format("give one of {}, or <probe>.<column>.<{}>", fmt::join(run_quantity_names(), ", "),
                         fmt::join(series_statistics, "|"));
  return fmt::format("no quantity '{}'; {}", files::one_line(name), cure);
}

SnapshotPlan read_snapshot(const document::Table& root, double step) {
  SnapshotPlan plan;
  const auto t = root.optional_table("snapshot");
  if (!t) return plan;
  if (t->optional(snapshot_keys.every)) plan.every = read_interval(*t, snapshot_keys.every, step);
  if (t->optional(snapshot_keys.image_every))
    plan.image_every = read_interval(*t, snapshot_keys.image_every, step);
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

std::vector<ChartPlan> read_charts(const document::Table& root, const std::vector<ProbePlan>& probes,
                                   int dimension) {
  std::vector<ChartPlan> charts;
  UniqueNames names("chart");
  for (const document::Table& t : root.tables("chart")) {
    charts.push_back(read_chart(t, probes, dimension));
    names.add(t, charts.back().name);
  }
  return charts;
}

void read_expectations(const document::Table& root, Plan& plan) {
  const std::vector<std::string> known = quantity_names(plan.probes, plan.scene.dimension);
  for (const document::Table& t : root.tables("expect")) {
    Expectation e = read_expectation(t);
    if (const auto problem = quantity_problem(e.quantity, known, plan.spectrum))
      throw Error(fmt::format("{}: {}", t.place("quantity"), *problem));
    const bool of_peak = plan.spectrum && peak_quantity(e.quantity, plan.spectrum->observed);
    (of_peak ? plan.peak_expectations : plan.expectations).push_back(std::move(e));
  }
}

}  // namespace scree::scenario
