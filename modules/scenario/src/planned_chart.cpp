#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/charts/scaled_unit.hpp>
#include <scree/error.hpp>
#include <scree/scenario/charts.hpp>

namespace scree::scenario {

namespace {

using Column = std::vector<double> charts::ChartSeries::*;

// Gives the values of an axis a suitable prefix; returns the label with the unit.
std::string scale_axis(charts::ChartSpec& chart, Column column, const std::string& label,
                       const std::string& unit) {
  double largest = 0;
  for (const charts::ChartSeries& series : chart.series)
    for (const double value : series.*column)
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  const charts::ScaledUnit scaled = charts::scaled_unit(largest, unit);
  for (charts::ChartSeries& series : chart.series)
    for (double& value : series.*column) value *= scaled.factor;
  if (unit.empty()) return label;
  return label.empty() ? scaled.symbol : fmt::format("{} ({})", label, scaled.symbol);
}

// One curve for each of the times, over the middles of the bins.
void add_profile(const ProfilePlan& profile, const ColumnOf& column, charts::ChartSpec& chart) {
  const std::vector<double> times = column(profile.probe, "time");
  if (times.empty()) return;
  std::vector<std::vector<double>> values;
  for (const std::string& name : profile.columns) values.push_back(column(profile.probe, name));
  const std::size_t curves = std::min(std::size_t(profile.curves), times.size());
  const double width = (profile.high - profile.low) / double(values.size());
  for (std::size_t n = 0; n < curves; ++n) {
    const std::size_t row = (n + 1) * times.size() / curves - 1;
    charts::ChartSeries series{fmt::format("t = {:.4g} s", times[row]), {}, {}};
    for (std::size_t k = 0; k < values.size(); ++k) {
      series.x.push_back(profile.low + (double(k) + 0.5) * width);
      series.y.push_back(values[k][row]);
    }
    chart.series.push_back(std::move(series));
  }
}

}  // namespace

charts::ChartSpec chart_of(const ChartPlan& plan, const ColumnOf& column) {
  charts::ChartSpec chart;
  chart.title = plan.title;
  chart.log_x = plan.log_x;
  chart.log_y = plan.log_y;
  for (const CurvePlan& curve : plan.curves)
    if (std::vector<double> x = column(curve.probe, curve.x); !x.empty())
      chart.series.push_back({curve.name, std::move(x), column(curve.probe, curve.y)});
  if (plan.profile) add_profile(*plan.profile, column, chart);
  chart.x_label = scale_axis(chart, &charts::ChartSeries::x, plan.x_label, plan.x_unit);
  chart.y_label = scale_axis(chart, &charts::ChartSeries::y, plan.y_label, plan.y_unit);
  if (chart.series.empty()) throw Error("its probe has no samples; add a stage in which it samples");
  return chart;
}

}  // namespace scree::scenario
