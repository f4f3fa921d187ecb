#include "scree/spectrum/time_series.hpp"

#include <cmath>

#include <fmt/format.h>

#include <scree/files/csv_rows.hpp>

namespace scree::spectrum {

namespace {

// Squares of values and inverse steps are finite.
constexpr double largest = 1e150, shortest = 1e-150;

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
  if (!(series.duration() > shortest))
    rows.fail(1, fmt::format("the times span {} s", series.duration()), "check the unit of the times, s");
  return series;
}

}  // namespace scree::spectrum
