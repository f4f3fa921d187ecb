#include "campaign_charts.hpp"

#include "html.hpp"
#include "numbers.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/charts/scaled_unit.hpp>

namespace scree::report {

namespace {

constexpr std::size_t most_charts = 24, most_curves = 7;  // as many as there are colours

// The values of all keys but one, as the name of a curve.
std::string name_of(const CampaignTable& table, const Combination& combination, std::size_t key) {
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < table.keys().size(); ++k)
    if (k != key && table.keys()[k] == "case")
      parts.push_back(combination.values[k]);
    else if (k != key)
      parts.push_back(fmt::format("{} = {}", table.short_name(k), combination.values[k]));
  return fmt::format("{}", fmt::join(parts, ", "));
}

struct Point {
  double x;
  Mean y;
};

// By their names, in the order of the table; points in the order of the key.
std::vector<std::pair<std::string, std::vector<Point>>> curves_of(const CampaignTable& table, std::size_t key,
                                                                  const std::string& quantity) {
  std::vector<std::pair<std::string, std::vector<Point>>> curves;
  for (const Combination& combination : table.combinations()) {
    const Mean mean = table.mean(combination, quantity);
    if (!std::isfinite(mean.mean)) continue;
    const std::string name = name_of(table, combination, key);
    auto curve = std::find_if(curves.begin(), curves.end(), [&](const auto& c) { return c.first == name; });
    if (curve == curves.end()) curve = curves.insert(curves.end(), {name, {}});
    curve->second.push_back({parsed(combination.values[key]), mean});
  }
  for (auto& [name, points] : curves)
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  return curves;
}

// Whether positive values spread over more than a range.
bool is_wide(const std::vector<double>& values, double range) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return !values.empty() && *low > 0 && *high > range * *low;
}

std::string label_of(const std::string& quantity, const std::string& unit) {
  return unit.empty() ? quantity : fmt::format("{} ({})", quantity, unit);
}

charts::ChartSpec chart_of(const CampaignTable& table, std::size_t key, const std::string& quantity,
                           std::size_t& left_out) {
  const auto curves = curves_of(table, key, quantity);
  left_out = curves.size() - std::min(curves.size(), most_curves);
  std::vector<double> xs, ys;
  for (const auto& [name, points] : curves)
    for (const Point& point : points) xs.push_back(point.x), ys.push_back(point.y.mean);
  double largest = 0;
  for (const double y : ys) largest = std::max(largest, std::abs(y));
  const charts::ScaledUnit unit = charts::scaled_unit(largest, table.unit(quantity));
  charts::ChartSpec chart;
  chart.title = fmt::format("{} over {}", quantity, table.short_name(key));
  chart.x_label = table.short_name(key);
  chart.y_label = label_of(quantity, unit.symbol);
  chart.log_x = is_wide(xs, 30);
  chart.log_y = is_wide(ys, 100);
  for (std::size_t k = 0; k < std::min(curves.size(), most_curves); ++k) {
    charts::ChartSeries curve;
    curve.name = curves[k].first;
    curve.markers = true;
    for (const Point& point : curves[k].second) {
      curve.x.push_back(point.x);
      curve.y.push_back(unit.factor * point.y.mean);
      curve.y_error.push_back(unit.factor * point.y.standard_error);
    }
    chart.series.push_back(std::move(curve));
  }
  return chart;
}

}  // namespace

void add_campaign_charts(const CampaignTable& table, Figures& figures) {
  std::size_t drawn = 0, not_drawn = 0;
  for (const std::string& quantity : table.quantities())
    for (std::size_t key = 0; key < table.keys().size(); ++key) {
      if (!table.is_numeric(key)) continue;
      if (drawn == most_charts) {
        ++not_drawn;
        continue;
      }
      std::size_t left_out = 0;
      charts::ChartSpec chart = chart_of(table, key, quantity, left_out);
      if (chart.series.empty()) continue;  // no run has finished
      if (left_out)
        chart.title += fmt::format("; {} of {} combinations are not drawn", left_out, left_out + most_curves);
      figures.add_chart(std::move(chart));
      ++drawn;
    }
  if (not_drawn)
    figures.add_line(escaped(fmt::format("{} more are not drawn; collect fewer quantities.", not_drawn)));
}

}  // namespace scree::report
