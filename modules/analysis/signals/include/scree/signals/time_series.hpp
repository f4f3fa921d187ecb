#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scree::signals {

// One column of a CSV file over its first, the time.
struct TimeSeries {
  std::string name, unit;      // of the column; the unit is empty if the header has none
  std::vector<double> times;   // (s) increasing
  std::vector<double> values;  // as many
  std::size_t cut_line = 0;  // number of the last line if it has no line break, as in a file that was cut off
  double duration() const { return times.back() - times.front(); }
  double mean_step() const { return duration() / double(times.size() - 1); }
};

// Reads columns of a file over the first in one pass, row by row; nothing else of it is kept. columns: their names, with units or without. Throws Error
// "file:line:column: ..." for a missing column, an empty or a text cell, NaN, numbers beyond 1e150, values of which none reaches 1e-150 unless all are 0, times that do not increase, and fewer than `least`
// rows (2 or more).
std::vector<TimeSeries> read_time_series(const std::filesystem::path& file,
                                         const std::vector<std::string>& columns, std::size_t least);

// One column.
TimeSeries read_time_series(const std::filesystem::path& file, const std::string& column, std::size_t least);

}  // namespace scree::signals
