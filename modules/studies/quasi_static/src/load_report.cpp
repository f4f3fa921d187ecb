#include "load_report.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/charts/draw_chart.hpp>
#include <scree/charts/scaled_unit.hpp>
#include <scree/counted.hpp>

namespace scree::quasi_static {

using Json = nlohmann::ordered_json;

constexpr double most_whole_cycles = 4;  // drawn one after the other; of more, the first and the last

Json record_of(const FollowedLoad& load) {
  Json json = {{"title", load.title}, {"bodies", load.bodies}};
  json["degrees_of_freedom"] = load.degrees_of_freedom;
  json["start"] = load.start;
  json["end"] = load.reached;
  if (load.reached < load.end) json["planned_end"] = load.end;
  json["increment"] = load.increment;
  json["period"] = load.period;
  json["increments"] = load.increments;
  json["iterations"] = load.iterations;
  json["events"] = load.events;
  json["dynamic_steps"] = load.dynamic_steps;
  json["hand_overs"] = Json::array();
  for (const HandOver& h : load.hand_overs) json["hand_overs"].push_back({{"from", h.from}, {"to", h.to}});
  json["wall_s"] = {{"all", load.wall_time}, {"dynamic", load.dynamic_wall_time}};
  return json;
}

namespace {

// The part of a load between two times (s), over the time since `zero`.
charts::ChartSeries part_of(const std::vector<double>& times, const std::vector<double>& values, double from,
                            double to, double zero) {
  charts::ChartSeries curve;
  for (std::size_t k = 0; k < times.size(); ++k)
    if (times[k] >= from && times[k] <= to) curve.x.push_back(times[k] - zero), curve.y.push_back(values[k]);
  return curve;
}

}  // namespace

namespace {

// A curve with its label and unit.
struct Curve {
  std::string label;
  std::vector<double> values;
};

Curve scaled(const std::string& what, const std::string& unit, std::vector<double> values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  const charts::ScaledUnit scale = charts::scaled_unit(largest, unit);
  for (double& value : values) value *= scale.factor;
  return {fmt::format("{} ({})", what, scale.symbol), std::move(values)};
}

Curve charted_curve(const ChartedLoad& charted) {
  if (charted.surface.empty()) return {"strain L_y/L_y0 - L_x/L_x0", charted.values};
  return scaled("displacement of " + charted.surface, "m", charted.values);
}

// One cycle after the other, or of more than a few the first and the last.
void draw_over_time(const ChartedLoad& charted, const Curve& curve, const run::RunDirectory& directory) {
  const FollowedLoad& load = charted.load;
  charts::ChartSpec chart;
  chart.title = load.title + ", quasi-static";
  chart.y_label = curve.label;
  const double end = charted.times.back(), slack = 1e-9 * load.period;
  if (load.period > 0 && end - load.start >= most_whole_cycles * load.period) {
    const double cycles = std::floor((end - load.start) / load.period + 1e-9);
    chart.x_label = "time in the cycle (s)";
    for (const double cycle : {1.0, cycles}) {
      const double from = load.start + (cycle - 1) * load.period;
      chart.series.push_back(
          part_of(charted.times, curve.values, from - slack, from + load.period + slack, from));
      chart.series.back().name = fmt::format("cycle {:g}", cycle);
    }
  } else {
    chart.x_label = "time (s)";
    chart.series.push_back(part_of(charted.times, curve.values, load.start, end, 0));
  }
  charts::draw_chart(
      chart, directory.add(charted.surface.empty() ? "charts/strain.png" : "charts/displacement.png"));
}

}  // namespace

void draw_charts(const ChartedLoad& charted, const run::RunDirectory& directory) {
  const bool drawn =
      charted.values.size() > 1 && std::all_of(charted.values.begin(), charted.values.end(),
                                               [](double value) { return std::isfinite(value); });
  if (!drawn) return;
  const Curve curve = charted_curve(charted);
  draw_over_time(charted, curve, directory);
  if (charted.surface.empty()) return;
  const Curve force = scaled("force of " + charted.surface, "N", charted.forces);
  charts::ChartSpec chart;
  chart.title = charted.load.title + ", quasi-static";
  chart.x_label = curve.label, chart.y_label = force.label;
  charts::ChartSeries loop;
  loop.x = curve.values, loop.y = force.values;
  chart.series.push_back(std::move(loop));
  charts::draw_chart(chart, directory.add("charts/force.png"));
}

std::string text_report(const FollowedLoad& c) {
  std::string text = fmt::format(
      "{}, {} degrees of freedom; {:g} to {:g} s in {} of at most {:g} s\n"
      "{} of Newton's method; contacts opened, closed, began or ended to slide {}\n",
      counted(c.bodies, "body", "bodies"), c.degrees_of_freedom, c.start, c.reached,
      counted(c.increments, "increment"), c.increment, counted(c.iterations, "iteration"),
      counted(c.events, "time"));
  if (!c.hand_overs.empty())
    text += fmt::format("{:g} s of {:g} s by dynamics, in {}, where there was no equilibrium nearby\n",
                        c.dynamic_time(), c.reached - c.start, counted(c.hand_overs.size(), "part"));
  text += fmt::format("{:.3g} s of wall time", c.wall_time);
  if (c.period > 0 && c.reached > c.start)
    text += fmt::format(", {:.3g} ms per cycle", 1e3 * c.wall_time * c.period / (c.reached - c.start));
  return text + "\n";
}

}  // namespace scree::quasi_static
