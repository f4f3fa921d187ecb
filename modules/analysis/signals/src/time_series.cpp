#include "scree/signals/time_series.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include <scree/files/csv_rows.hpp>
#include <scree/files/text.hpp>

namespace scree::signals {

namespace {

// Within these, squares of values and inverse steps are finite and not 0.
constexpr double largest = 1e150, smallest = 1e-150;

// The unit of time other than s at the end of a name, as in "time (ms)" and "time_ms"; empty if there is
// none.
std::string unit_in(const std::string& name) {
  static const std::set<std::string> units = {"ms", "us", "µs", "ns", "min", "h"};
  const std::size_t before = name.find_last_of("_ (/");
  if (before == std::string::npos) return "";
  std::string last = name.substr(before + 1);
  if (last.ends_with(')')) last.pop_back();
  return units.contains(last) ? last : "";
}

void check_unit(const files::CsvRows& rows) {
  const auto& [name, unit] = rows.columns()[0];
  if (!unit.empty() && unit != "s")
    rows.fail(1, fmt::format("the first column has the unit {}", files::quote_token(unit)),
              "give times in s there");
  if (const std::string named = unit_in(name); unit.empty() && !named.empty())
    rows.fail(
        1, fmt::format("the first column, {}, has the unit {} in its name", files::quote_token(name), named),
        "give times in s there, or another name");
}

// The squares of tiny values, and so the errors, would be 0.
void check_size(const files::CsvRows& rows, const std::vector<double>& values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  if (size > 0 && size < smallest)
    rows.fail(1, fmt::format("no value is above {}", size),
              fmt::format("give another unit, in which one is above {}", smallest));
}

double read(const files::CsvRows& rows, std::size_t cell) {
  const double value = rows.number(cell);
  if (std::abs(value) > largest)
    rows.fail(1, fmt::format("{} is beyond {}", value, largest), "check it, or give another unit");
  return value;
}

void check(const files::CsvRows& rows, const TimeSeries& series, std::size_t least) {
  if (series.times.size() < least)
    rows.fail(1,
              fmt::format("the file ends after {} sample{}", series.times.size(),
                          series.times.size() == 1 ? "" : "s"),
              fmt::format("give {} or more", least));
  if (!(series.duration() > smallest))
    rows.fail(1, fmt::format("the times span {} s", series.duration()), "check the unit of the times, s");
  check_size(rows, series.values);
}

}  // namespace

std::vector<TimeSeries> read_time_series(const std::filesystem::path& file,
                                         const std::vector<std::string>& columns, std::size_t least) {
  files::CsvRows rows(file);
  std::vector<std::size_t> numbers;
  std::vector<TimeSeries> series;
  for (const std::string& column : columns) {
    const std::size_t number = rows.column(column);
    numbers.push_back(number);
    series.push_back({rows.columns()[number].name, rows.columns()[number].unit, {}, {}, 0});
  }
  check_unit(rows);
  std::vector<double> times;
  std::size_t cut_line = 0;
  while (rows.next()) {
    const double time = read(rows, 0);
    if (!times.empty() && !(time > times.back()))
      rows.fail(1, fmt::format("time {} follows {}", time, times.back()),
                "give times that increase, in the first column");
    times.push_back(time);
    for (std::size_t k = 0; k < series.size(); ++k) series[k].values.push_back(read(rows, numbers[k]));
    if (!rows.is_whole()) cut_line = rows.line_number();
  }
  for (TimeSeries& column : series) {
    column.times = times;
    column.cut_line = cut_line;
    check(rows, column, least);
  }
  return series;
}

TimeSeries read_time_series(const std::filesystem::path& file, const std::string& column, std::size_t least) {
  return std::move(read_time_series(file, std::vector<std::string>{column}, least).front());
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return files::one_line(unit.empty() ? name : fmt::format("{} [{}]", name, unit));
}

std::string cut_line_warning(std::size_t cut_line) {
  if (cut_line == 0) return "";
  return fmt::format(
      "line {}, the last, has no line break, so that its last number may be cut off; check it, and end the line",
      cut_line);
}

}  // namespace scree::signals
