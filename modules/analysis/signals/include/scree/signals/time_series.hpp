#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace scree::signals {

// One column of a CSV file over its first, the time.
struct TimeSeries {
  std::string name, unit;      // of the column; the unit is empty if the header has none
  std::vector<double> times;   // (s) increasing
  std::vector<double> values;  // as many
  std::size_t cut_line =
      0;  // number of the last line if it has no line break, as in a file that was cut off; else 0
  double duration() const { return times.back() - times.front(); }
  double mean_step() const { return duration() / double(times.size() - 1); }
};

// Reads columns of a file over the first, in one pass, row by row. columns: their names, with units or
// without; least: rows, 2 or more. Throws Error "file:line:column: ..." for a missing column, an empty cell,
// text, NaN, numbers beyond 1e150, values that are all below 1e-150 but not all 0, times that do not
// increase, and fewer rows.
std::vector<TimeSeries> read_time_series(const std::filesystem::path& file,
                                         const std::vector<std::string>& columns, std::size_t least);

// Reads one column.
TimeSeries read_time_series(const std::filesystem::path& file, const std::string& column, std::size_t least);

// "<name> [<unit>]" in one line; the name alone without a unit.
std::string with_unit(const std::string& name, const std::string& unit);

// Warns that the last line of a file may be cut off; empty for cut_line 0.
std::string cut_line_warning(std::size_t cut_line);

}  // namespace scree::signals
