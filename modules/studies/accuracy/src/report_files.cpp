#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/accuracy/report.hpp>
#include <scree/charts/draw_chart.hpp>

namespace scree::accuracy {

namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& x) { return x ? Json(*x) : Json(nullptr); }

Json order_of(const Convergence& study, std::size_t method) {
  const Order& order = study.orders[method];
  const LongestStep& longest = study.longest_steps[method];
  Json json = {{"integrator", traits_of(order.integration).name},
               {"order", number_or_null(order.of_worst)},
               {"longest_step", number_or_null(longest.of_worst)}};
  if (!study.of_peaks) json["order_of_positions"] = number_or_null(order.of_quantities.back());
  for (std::size_t k = 0; k < study.quantities.size(); ++k)
    json["quantities"].push_back({{"name", study.quantities[k].name},
                                  {"order", number_or_null(order.of_quantities[k])},
                                  {"longest_step", number_or_null(longest.of_quantities[k])}});
  return json;
}

void add_point(charts::ChartSeries& series, const SettingResult& o, std::optional<std::size_t> quantity) {
  const double error = o.error(quantity);
  if (!(error > 0 && std::isfinite(error) && o.wall_time > 0)) return;  // not possible on a logarithmic axis
  series.x.push_back(o.wall_time);
  series.y.push_back(error);
}

charts::ChartSeries front_of(const Convergence& study, std::optional<std::size_t> quantity) {
  charts::ChartSeries front{
      "Pareto front", {}, {}, std::array<double, 3>{0, 0, 0}, charts::LineStyle::dashed};
  for (const SettingResult* o : pareto_front(study, quantity)) add_point(front, *o, quantity);
  return front;
}

// One colour per integrator: blue, vermilion, green, purple; distinguishable for colour-blind readers.
std::array<double, 3> color_of(Integration integration) {
  static constexpr std::array<double, 3> colors[] = {
      {0.00, 0.45, 0.70}, {0.84, 0.37, 0.00}, {0.00, 0.62, 0.45}, {0.80, 0.47, 0.65}};
  return colors[std::size_t(integration) % std::size(colors)];
}

charts::ChartSpec chart_of(const Convergence& study, const std::string& title, const std::string& label,
                           std::optional<std::size_t> quantity) {
  charts::ChartSpec chart;
  chart.title = title;
  chart.x_label = "wall time (s)";
  chart.y_label = label;
  chart.log_x = chart.log_y = true;
  for (const Order& order : study.orders) {
    charts::ChartSeries series;
    series.name = traits_of(order.integration).name;
    series.markers = true;
    series.color = color_of(order.integration);
    for (const SettingResult& o : study.outcomes)
      if (o.problem.empty() && o.setting.integration == order.integration) add_point(series, o, quantity);
    if (!series.x.empty()) chart.series.push_back(std::move(series));
  }
  chart.series.push_back(front_of(study, quantity));
  return chart;
}

void draw(const charts::ChartSpec& chart, std::string name, const run::RunDirectory& files) {
  if (chart.series.size() < 2 || chart.series.back().x.empty()) return;  // all errors are 0
  std::replace(name.begin(), name.end(), '/', '_');                      // of a peak 3λ/4
  charts::draw_chart(chart, files.add("charts/" + name + ".png"));
}

}  // namespace

Json record_of(const Convergence& study) {
  Json json = {{"verdict", verdict(study)},     {"tolerance", study.tolerance},
               {"compared_at", study.duration}, {"trustworthy_until", number_or_null(study.horizon)},
               {"notes", study.notes},          {"interrupted", study.interrupted}};
  for (const Quantity& q : study.quantities)
    json["quantities"].push_back({{"name", q.name},
                                  {"reference", q.reference},
                                  {"uncertainty", q.uncertainty},
                                  {"closed_form", q.closed_form}});
  for (std::size_t m = 0; m < study.orders.size(); ++m) json["orders"].push_back(order_of(study, m));
  return json;
}

Json json_of(const StudyOptions& options) {
  Json json = {{"tolerance", options.tolerance}, {"coarsest", options.coarsest}, {"count", options.count}};
  for (const Integration integration : options.integrations)
    json["integrator"].push_back(traits_of(integration).name);
  for (const std::string& quantity : options.quantities) json["quantity"].push_back(quantity);
  return json;
}

void write_table(const Convergence& study, const run::RunDirectory& directory) {
  directory.write_file("accuracy.csv", csv_report(study));
}

void draw_charts(const Convergence& study, const std::string& title, const run::RunDirectory& directory) {
  constexpr std::size_t max_charts = 6;
  draw(chart_of(study, title, "largest relative error of all quantities", std::nullopt), "worst_error",
       directory);
  for (std::size_t k = 0; k < study.quantities.size(); ++k)
    if (k < max_charts || k + 1 == study.quantities.size())
      draw(chart_of(study, title, fmt::format("error of {}", study.quantities[k].name), k),
           study.quantities[k].name, directory);
}

}  // namespace scree::accuracy
