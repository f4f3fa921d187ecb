#include "sampler.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/charts/draw_chart.hpp>
#include <scree/document/document.hpp>
#include <scree/error.hpp>
#include <scree/report/result_tables.hpp>
#include <scree/run/charts.hpp>
#include <scree/run/series.hpp>
#include <scree/run/written_files.hpp>
#include <scree/scenario/charts.hpp>

namespace scree::run {

namespace fs = std::filesystem;

namespace {

// Columns of a chart whose first value has no logarithm on its axis.
std::vector<std::string> without_logarithm(const scenario::ChartPlan& chart, const Sampler& sampler) {
  std::vector<std::string> found;
  const auto look = [&](bool logarithmic, const scenario::CurvePlan& curve, const std::string& name) {
    const Series& series = sampler.series(curve.probe);
    if (!logarithmic || series.rows() == 0 || series.column(name)[0] > 0) return;
    if (std::find(found.begin(), found.end(), name) == found.end()) found.push_back(name);
  };
  for (const scenario::CurvePlan& curve : chart.curves) {
    look(chart.log_x, curve, curve.x);
    look(chart.log_y, curve, curve.y);
  }
  return found;
}

}  // namespace

std::vector<std::string> left_out_at_start(const scenario::Plan& plan, const Simulation& simulation) {
  const auto is_logarithmic = [](const scenario::ChartPlan& chart) { return chart.log_x || chart.log_y; };
  std::vector<std::string> lines;
  if (plan.stages.empty() || std::none_of(plan.charts.begin(), plan.charts.end(), is_logarithmic))
    return lines;
  Sampler sampler(plan);
  sampler.open();
  sampler.take(simulation, plan.stages.front().name, 0);
  for (const scenario::ChartPlan& chart : plan.charts)
    if (const auto columns = without_logarithm(chart, sampler); !columns.empty())
      lines.push_back(fmt::format(
          "chart {}: at t = {:g} s there is no logarithm of {}, so that these points are left out",
          chart.name, simulation.time(), fmt::join(columns, ", ")));
  return lines;
}

namespace {

// Charts of the run itself are drawn again; other files are replaced only if that is asked for.
fs::path place_of(const ChartRequest& request, std::optional<WrittenFiles>& list, const std::string& file) {
  if (list && list->contains("charts/" + file)) return request.run / "charts" / file;
  const fs::path path = (list ? request.run / "charts" : request.out) / file;
  std::error_code failed;
  if (!request.overwrite && fs::exists(fs::symlink_status(path, failed)))
    throw Error(fmt::format("{}: is there already; give another --out, or --overwrite", path.string()));
  return list ? list->add("charts/" + file) : path;
}

}  // namespace

void redraw_charts(const ChartRequest& request, const std::function<void(const fs::path&)>& drawn) {
  const fs::path scenario = request.scenario.empty() ? request.run / "scenario.toml" : request.scenario;
  const std::map<std::string, fs::path> tables = report::tables_in(request.run);
  if (tables.empty())
    throw Error(fmt::format(
        "{}: contains no series/*.csv and no *.csv; give the directory of a run with probes, or of a study",
        request.run.string()));
  const document::Document document = document::Document::load(scenario, request.overrides);
  const std::vector<scenario::ChartPlan> plans =
      scenario::read_charts(document.root(), report::columns_of(tables));
  for (const document::Table& chart : document.root().tables("chart")) chart.refuse_unused();
  if (plans.empty())
    throw Error(
        fmt::format("{}: has no [[chart]]; add one, or name a scenario that has some", scenario.string()));
  const scenario::ColumnOf column = [&](const std::string& probe, const std::string& name) {
    return series_column(tables.at(probe), name, "choose a column of numbers, or wait until the run ends");
  };
  std::optional<WrittenFiles> written;
  if (request.out.empty()) written.emplace(request.run);
  std::vector<fs::path> places;
  for (const scenario::ChartPlan& chart : plans)
    places.push_back(place_of(request, written, chart.file_name()));
  for (std::size_t k = 0; k < plans.size(); ++k) {
    charts::draw_chart(scenario::chart_of(plans[k], column), places[k]);
    drawn(places[k]);
  }
}

}  // namespace scree::run
