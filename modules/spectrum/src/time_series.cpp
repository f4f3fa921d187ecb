#include "scree/spectrum/time_series.hpp"

#include <fmt/format.h>

#include <scree/files/csv_rows.hpp>

namespace scree::spectrum {

TimeSeries read_time_series(const std::filesystem::path& file, const std::string& column, std::size_t least) {
  files::CsvRows rows(file);
  const std::size_t number = rows.column(column);
  if (const std::string& unit = rows.columns()[0].unit; !unit.empty() && unit != "s")
    rows.fail(1, fmt::format("the first column has the unit {}", files::quote_token(unit)),
              "give times in s there");
  TimeSeries series{rows.columns()[number].name, rows.columns()[number].unit, {}, {}};
  while (rows.next()) {
    const double time = rows.number(0);
    if (!series.times.empty() && !(time > series.times.back()))
      rows.fail(1, fmt::format("time {} follows {}", time, series.times.back()),
                "give times that increase, in the first column");
    series.times.push_back(time);
    series.values.push_back(rows.number(number));
  }
  if (series.times.size() < least)
    rows.fail(1, fmt::format("the file ends after {} samples", series.times.size()),
              fmt::format("give {} or more", least));
  return series;
}

}  // namespace scree::spectrum
