#include "common_sections.hpp"
#include "figures.hpp"
#include "html.hpp"
#include "numbers.hpp"
#include "text_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include <scree/report/record.hpp>

// The page of an accuracy study.
namespace scree::report {

namespace {

using charts::ChartSeries;
using charts::LineStyle;

bool is_drawn(const TextTable& table, std::size_t row) {
  return table.number(row, "worst_error") > 0 && table.number(row, "wall_s") > 0;
}

// Settings that no other beats in both time and error, the fastest first.
std::vector<std::size_t> front_of(const TextTable& table) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < table.rows(); ++k)
    if (is_drawn(table, k)) rows.push_back(k);
  std::sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(table.number(a, "wall_s"), table.number(a, "worst_error")) <
           std::pair(table.number(b, "wall_s"), table.number(b, "worst_error"));
  });
  std::vector<std::size_t> front;
  for (const std::size_t row : rows)
    if (front.empty() || table.number(row, "worst_error") < table.number(front.back(), "worst_error"))
      front.push_back(row);
  return front;
}

// One colour per integrator, as in the charts of the study.
std::vector<ChartSeries> curves_of(const TextTable& table) {
  static constexpr std::array<std::array<double, 3>, 4> colors = {
      {{0.00, 0.45, 0.70}, {0.84, 0.37, 0.00}, {0.00, 0.62, 0.45}, {0.80, 0.47, 0.65}}};
  std::vector<ChartSeries> curves;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (!is_drawn(table, k)) continue;
    const std::string& name = table.text(k, "integrator");
    auto curve =
        std::find_if(curves.begin(), curves.end(), [&](const ChartSeries& c) { return c.name == name; });
    if (curve == curves.end()) {
      const auto& color = colors[curves.size() % colors.size()];
      curve = curves.insert(curves.end(), ChartSeries{name, {}, {}, color, LineStyle::solid, true});
    }
    curve->x.push_back(table.number(k, "wall_s"));
    curve->y.push_back(table.number(k, "worst_error"));
  }
  return curves;
}

std::string chart(const TextTable& table) {
  charts::ChartSpec chart;
  chart.title =
      "Error against wall time; no setting is faster and more accurate than those on the dashed line";
  chart.x_label = "wall time (s)";
  chart.y_label = "largest relative error of all quantities";
  chart.log_x = chart.log_y = true;
  chart.series = curves_of(table);
  ChartSeries front{"Pareto front", {}, {}, std::array<double, 3>{0, 0, 0}, LineStyle::dashed};
  for (const std::size_t row : front_of(table)) {
    front.x.push_back(table.number(row, "wall_s"));
    front.y.push_back(table.number(row, "worst_error"));
  }
  if (front.x.empty()) return "";  // all errors are 0
  chart.series.push_back(std::move(front));
  Figures figures;
  figures.add_chart(std::move(chart));
  return section("Speed against error", figures.html());
}

std::string rows_of(const TextTable& table, const std::vector<std::size_t>& rows, double tolerance) {
  Table html(
      {{"integrator"}, {"step", true}, {"steps", true}, {"wall time", true}, {"largest error", true}, {""}});
  for (const std::size_t k : rows) {
    const double error = table.number(k, "worst_error");
    const std::string& problem = table.text(k, "problem");
    const char* remark = error <= tolerance ? "<span class=\"good\">within the tolerance</span>" : "";
    html.add({escaped(table.text(k, "integrator")), with_unit(table.number(k, "step_s"), "s"),
              count_text(table.number(k, "steps")), duration_text(table.number(k, "wall_s")),
              number_text(error, 3), problem.empty() ? remark : escaped(problem)});
  }
  return html.html("accuracy.csv");
}

std::string settings(const TextTable& table, double tolerance) {
  std::vector<std::size_t> all(table.rows());
  std::iota(all.begin(), all.end(), std::size_t(0));
  return section(
      "The fastest settings for their errors",
      rows_of(table, front_of(table), tolerance) + folded("All settings", rows_of(table, all, tolerance)));
}

std::string orders(const Json& record) {
  Table table({{"integrator"},
               {"observed order", true},
               {"of positions", true},
               {"longest step within the tolerance", true}});
  for (const Json& order : list_in(record, "orders"))
    table.add({escaped(text_in(order, "integrator")), number_text(number_in(order, "order"), 3),
               number_text(number_in(order, "order_of_positions"), 3),
               with_unit(number_in(order, "longest_step"), "s")});
  return section("Orders", table.html("accuracy.json"));
}

std::string references(const Json& record) {
  Table table({{"quantity"}, {"reference", true}, {"uncertainty", true}, {"from"}});
  for (const Json& quantity : list_in(record, "quantities"))
    table.add({code(text_in(quantity, "name")), number_text(number_in(quantity, "reference"), 9),
               number_text(number_in(quantity, "uncertainty"), 2),
               is_true_in(quantity, "closed_form") ? "closed form" : "extrapolation"});
  return section("References", folded("What the results are compared with", table.html("accuracy.json")));
}

std::string notes(const Json& record) {
  std::string html;
  const double horizon = number_in(record, "trustworthy_until");
  if (!std::isnan(horizon))
    html += paragraph(
        fmt::format("Runs diverge under refinement of the step: the reference is trustworthy until {}.",
                    with_unit(horizon, "s")));
  for (const Json& note : list_in(record, "notes"))
    if (note.is_string()) html += paragraph(note.get<std::string>());
  return section("Notes", html);
}

}  // namespace

std::string accuracy_sections(const Results& results) {
  const TextTable table(results.directory / "accuracy.csv");
  const std::string words = text_in(results.record, "verdict");
  return verdict(results) + (words.empty() ? "" : element("p", escaped(words), "lead") + '\n') +
         chart(table) + settings(table, number_in(results.record, "tolerance")) + orders(results.record) +
         notes(results.record) + warnings(results) + references(results.record) + repetition(results);
}

}  // namespace scree::report
