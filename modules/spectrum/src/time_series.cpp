#include "scree/spectrum/time_series.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/files/csv_rows.hpp>

namespace scree::spectrum {

namespace {

// Squares of values and inverse steps are finite and not 0.
constexpr double largest = 1e150, smallest = 1e-150;

// Of values all of which are tiny the squares, and with them the errors, would be 0.
void check_size(const files::CsvRows& rows, const std::vector<double>& values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  if (size > 0 && size < smallest)
    rows.fail(1, fmt::format("no value is above {}", size),
              fmt::format("give another unit, in which one is above {}", smallest));
}

}  // namespace

TimeSeries read_time_series(const std::filesystem::path& file, const std::string& column, std::size_t least) {
  files::CsvRows rows(file);
  const std::size_t number = rows.column(column);
  if (const std::string& unit = rows.columns()[0].unit; !unit.empty() && unit != "s")
    rows.fail(1, fmt::format("the first column has the unit {}", files::quote_token(unit)),
              "give times in s there");
  TimeSeries series{rows.columns()[number].name, rows.columns()[number].unit, {}, {}};
  const auto read = [&](std::size_t cell) {
    const double value = rows.number(cell);
    if (std::abs(value) > largest)
      rows.fail(1, fmt::format("{} is beyond {}", value, largest), "check it, or give another unit");
    return value;
  };
  while (rows.next()) {
    const double time = read(0);
    if (!series.times.empty() && !(time > series.times.back()))
      rows.fail(1, fmt::format("time {} follows {}", time, series.times.back()),
                "give times that increase, in the first column");
    series.times.push_back(time);
    series.values.push_back(read(number));
  }
  if (series.times.size() < least)
    rows.fail(1,
              fmt::format("the file ends after {} sample{}", series.times.size(),
                          series.times.size() == 1 ? "" : "s"),
              fmt::format("give {} or more", least));
  if (!(series.duration() > smallest))
    rows.fail(1, fmt::format("the times span {} s", series.duration()), "check the unit of the times, s");
  check_size(rows, series.values);
  return series;
}

}  // namespace scree::spectrum
