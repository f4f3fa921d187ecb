#include "course_files.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/counted.hpp>
#include <scree/pictures/load_backend.hpp>
#include <scree/run/input_hashes_json.hpp>

namespace scree::quasi_static {

using Json = nlohmann::ordered_json;

constexpr double most_whole_cycles = 4;  // drawn one after the other; of more, the first and the last

void write_record(const std::string& status, const Course& c, const run::RunDirectory& directory) {
  Json json = {{"version", SCREE_VERSION}, {"status", status}, {"title", c.title}};
  if (!c.error.empty()) json["error"] = c.error;
  json["bodies"] = c.bodies;
  json["degrees_of_freedom"] = c.degrees_of_freedom;
  json["start"] = c.start;
  json["end"] = c.reached;
  if (c.reached < c.end) json["planned_end"] = c.end;
  json["increment"] = c.increment;
  json["period"] = c.period;
  json["increments"] = c.increments;
  json["iterations"] = c.iterations;
  json["events"] = c.events;
  json["dynamic_steps"] = c.dynamic_steps;
  json["hand_overs"] = Json::array();
  for (const HandOver& h : c.hand_overs) json["hand_overs"].push_back({{"from", h.from}, {"to", h.to}});
  json["wall"] = {{"all", c.wall}, {"dynamic", c.dynamic_wall}};
  json["warnings"] = c.warnings;
  json["inputs"] = run::json_of(c.inputs);
  json["scenario"] = c.scenario;
  directory.write_file("response.json", json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

namespace {

// The part of a course between two times (s), over the time since `zero`.
pictures::ChartSeries part_of(const std::vector<double>& times, const std::vector<double>& strains,
                              double from, double to, double zero) {
  pictures::ChartSeries curve;
  for (std::size_t k = 0; k < times.size(); ++k)
    if (times[k] >= from && times[k] <= to) curve.x.push_back(times[k] - zero), curve.y.push_back(strains[k]);
  return curve;
}

}  // namespace

void draw_chart(const Course& course, const std::vector<double>& times, const std::vector<double>& strains,
                const run::RunDirectory& directory) {
  const bool drawn = strains.size() > 1 &&
                     std::all_of(strains.begin(), strains.end(), [](double s) { return std::isfinite(s); });
  if (!drawn || !pictures::has_pictures()) return;
  pictures::ChartSpec chart;
  chart.title = course.title + ", quasi-static";
  chart.y_label = "strain L_y/L_y0 - L_x/L_x0";
  const double end = times.back(), slack = 1e-9 * course.period;
  if (course.period > 0 && end - course.start >= most_whole_cycles * course.period) {
    const double cycles = std::floor((end - course.start) / course.period + 1e-9);
    chart.x_label = "time in the cycle (s)";
    for (const double cycle : {1.0, cycles}) {
      const double from = course.start + (cycle - 1) * course.period;
      chart.series.push_back(part_of(times, strains, from - slack, from + course.period + slack, from));
      chart.series.back().name = fmt::format("cycle {:g}", cycle);
    }
  } else {
    chart.x_label = "time (s)";
    chart.series.push_back(part_of(times, strains, course.start, end, 0));
  }
  pictures::load_backend()->chart(chart, directory.add("charts/strain.png"));
}

std::string text_report(const Course& c) {
  std::string text = fmt::format(
      "{}, {} degrees of freedom; {:g} to {:g} s in {} of at most {:g} s\n"
      "{} of Newton's method; contacts opened, closed, began or ended to slide {}\n",
      counted(c.bodies, "body", "bodies"), c.degrees_of_freedom, c.start, c.reached,
      counted(c.increments, "increment"), c.increment, counted(c.iterations, "iteration"),
      counted(c.events, "time"));
  if (!c.hand_overs.empty())
    text += fmt::format("{:g} s of {:g} s by dynamics, in {}, where there was no equilibrium nearby\n",
                        c.dynamic_time(), c.reached - c.start, counted(c.hand_overs.size(), "part"));
  text += fmt::format("{:.3g} s of wall time", c.wall);
  if (c.period > 0 && c.reached > c.start)
    text += fmt::format(", {:.3g} ms per cycle", 1e3 * c.wall * c.period / (c.reached - c.start));
  return text + "\n";
}

}  // namespace scree::quasi_static
