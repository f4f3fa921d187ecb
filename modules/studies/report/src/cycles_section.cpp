#include "common_sections.hpp"
#include "figures.hpp"
#include "html.hpp"
#include "numbers.hpp"
#include "text_table.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/files/text_file.hpp>
#include <scree/report/record.hpp>

// What scree cycles has found about the results, from the files that it leaves beside them.
namespace scree::report {

namespace fs = std::filesystem;

namespace {

// Empty if there is none, or no JSON.
Json cycles_record(const fs::path& file) {
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) return Json::object();
  try {
    return parse_record(files::read_text(file));
  } catch (const Error&) {  // one that is too large, or may not be read
    return Json::object();
  }
}

std::string numbers(const Json& record) {
  Facts facts;
  const Json& fit = object_in(record, "fit");
  const auto count = [&](const char* name, double value) {
    if (!std::isnan(value)) facts.add(name, count_text(value));
  };
  facts.add("why", escaped(text_in(record, "reason")));
  facts.add("series", code(text_in(record, "series")));
  facts.add("strain", code(text_in(record, "strain")));
  if (const std::string load = text_in(record, "load"); !load.empty()) facts.add("load", code(load));
  if (const double period = number_in(record, "period"); !std::isnan(period))
    facts.add("period", with_unit(period, "s"));
  count("cycles", number_in(record, "cycles"));
  count("dropped at the start", number_in(record, "dropped"));
  if (const double slope = number_in(fit, "slope"); !std::isnan(slope)) {
    facts.add("strain per cycle, by least squares", with_error(slope, number_in(fit, "slope_error")));
    facts.add("deviation from the line, rms", number_text(number_in(fit, "rms"), 3));
  }
  facts.add("law", escaped(text_in(object_in(record, "law"), "form")));
  if (const Json& outliers = list_in(record, "outliers"); !outliers.empty())
    count("outliers", double(outliers.size()));
  return facts.html();
}

// The strain at each minimum that counts, and the straight line through these.
void add_chart(const Results& results, const Json& record, Figures& figures) {
  const TextTable table(results.directory / "cycles.csv");
  if (table.columns().size() < 5 || table.rows() == 0) return;
  const auto& strain = table.columns()[2];
  charts::ChartSeries values{"at the minima of the load", {}, {}}, line{"line of least squares", {}, {}};
  values.line = charts::LineStyle::none;
  const double dropped = number_in(record, "dropped");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double cycle = table.number(row, "cycle");
    if (cycle < dropped) continue;
    for (const auto& [column, curve] :
         {std::pair(&strain.name, &values), {&table.columns()[3].name, &line}}) {
      curve->x.push_back(cycle);
      curve->y.push_back(table.number(row, *column));
    }
  }
  if (values.x.empty()) return;
  charts::ChartSpec chart;
  chart.title = "strain at the minima of the load";
  chart.x_label = "cycle";
  chart.y_label = strain.unit.empty() ? "strain" : fmt::format("strain ({})", strain.unit);
  chart.series = {thinned(values), thinned(line)};
  figures.add_chart(std::move(chart));
}

}  // namespace

std::string cycles_section(const Results& results) {
  const Json record = cycles_record(results.directory / "cycles.json");
  const std::string found = text_in(record, "class");
  if (found.empty()) return "";
  Figures figures;
  add_chart(results, record, figures);
  return section("Cycles",
                 paragraph(fmt::format("scree cycles: {}.", found)) + numbers(record) + figures.html());
}

std::string verdicts_of_cycles(const Results& results) {
  const TextTable verdicts(results.directory / "verdicts.csv");
  if (!verdicts.has("class") || !verdicts.has("slope")) return "";
  Table table(
      {{"run"}, {"class"}, {"cycles", true}, {"strain per cycle", true}, {"outliers", true}, {"why"}});
  for (std::size_t row = 0; row < verdicts.rows(); ++row)
    table.add({escaped(verdicts.text(row, "run")), escaped(verdicts.text(row, "class")),
               count_text(verdicts.number(row, "cycles")),
               with_error(verdicts.number(row, "slope"), verdicts.number(row, "slope_error")),
               count_text(verdicts.number(row, "outliers")), escaped(verdicts.text(row, "reason"))});
  return section("Cycles", table.html("verdicts.csv"));
}

}  // namespace scree::report
