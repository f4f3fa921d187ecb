#include "common_sections.hpp"
#include "figures.hpp"
#include "html.hpp"
#include "numbers.hpp"
#include "scene_charts.hpp"
#include "scene_facts.hpp"
#include "text_table.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/report/record.hpp>
#include <scree/report/result_tables.hpp>

// The page of modes or of a quasi-static load: what its record and its tables say.
namespace scree::report {

namespace fs = std::filesystem;

namespace {

// square_frequency becomes "square frequency".
std::string as_words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

// Of an entry of a record; empty if it has none, or none that is known.
std::string unit_of(const std::string& key, const Json& object) {
  static const std::set<std::string> times = {"start", "end", "planned_end", "increment", "period"};
  if (times.contains(key)) return "s";
  if (key == "distance") return "m";
  return key.find("modulus") != key.npos ? text_in(object, "unit") : "";
}

std::string with_its_unit(double number, const std::string& unit) {
  return unit.empty() ? number_text(number, 6) : with_unit(number, unit, 6);
}

// The numbers of an object, but those that a page has elsewhere.
std::string numbers_of(const std::string& title, const Json& object) {
  static const std::set<std::string> elsewhere = {"bodies", "degrees_of_freedom", "step", "time",
                                                  "seed",   "tolerance"};
  Facts facts;
  for (const auto& [key, value] : object.items()) {
    if (elsewhere.contains(key)) continue;
    if (value.is_number())
      facts.add(as_words(key), escaped(with_its_unit(value.get<double>(), unit_of(key, object))));
    if (value.is_boolean()) facts.add(as_words(key), value.get<bool>() ? "yes" : "no");
  }
  return section(title, facts.html());
}

std::string wall_times(const Json& record) {
  Facts facts;
  for (const auto& [what, seconds] : object_in(record, "wall_s").items())
    if (seconds.is_number()) facts.add(as_words(what), duration_text(seconds.get<double>()));
  return section("Wall times", facts.html());
}

// The beginning of a table; folded if there is more.
std::string table_of(const fs::path& file) {
  constexpr std::size_t most_rows = 30, most_columns = 14;
  const TextTable table(file);
  std::vector<Heading> headings;
  for (const auto& column : table.columns()) {
    if (headings.size() == most_columns) break;
    const std::string words = as_words(column.name);
    const bool is_number = table.rows() > 0 && !std::isnan(table.number(0, column.name));
    headings.push_back({column.unit.empty() ? words : fmt::format("{} ({})", words, column.unit), is_number});
  }
  Table html(headings);
  for (std::size_t k = 0; k < std::min(most_rows, table.rows()); ++k) {
    std::vector<std::string> cells;
    for (std::size_t c = 0; c < headings.size(); ++c) {
      const std::string& name = table.columns()[c].name;
      const double number = table.number(k, name);
      cells.push_back(std::isnan(number) ? escaped(table.text(k, name)) : number_text(number, 5));
    }
    html.add(std::move(cells));
  }
  const std::string name = file.filename().string();
  if (html.empty()) return "";
  const bool whole = table.rows() <= most_rows && table.columns().size() <= most_columns;
  if (whole) return element("h3", escaped(name)) + '\n' + html.html();
  return folded(fmt::format("{}, its beginning: {} of {}", name, std::min(most_rows, table.rows()),
                            counted(table.rows(), "row")),
                html.html());
}

std::string tables(const Results& results) {
  std::string html;
  for (const auto& [name, file] : tables_in(results.directory)) html += table_of(file);
  return section("Tables", html);
}

// PNG files of a folder, by name.
void add_pictures(const fs::path& folder, std::size_t most, Figures& figures) {
  std::set<fs::path> files;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (entry.path().extension() == ".png") files.insert(entry.path());
  for (const fs::path& file : files)
    if (most-- > 0)
      figures.add_picture(file, as_words(file.stem().string()));
    else
      break;
}

}  // namespace

std::string study_sections(const Results& results) {
  constexpr std::size_t most_pictures = 6;
  Figures figures;
  for (const char* folder : {"charts", "images"})
    add_pictures(results.directory / folder, most_pictures, figures);
  Columns columns(tables_in(results.directory));
  add_scene_charts(results, columns, figures);
  return verdict(results) + section("Charts", figures.html()) + cycles_section(results) +
         scene_facts(results) + numbers_of("Results", results.record) +
         numbers_of("Elastic constants", object_in(results.record, "elastic")) + wall_times(results.record) +
         expectations(results) + warnings(results) + tables(results) + repetition(results);
}

}  // namespace scree::report
