#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <scree/cycles/cycle_series.hpp>

namespace scree::cycles {

// Which series `scree cycles` takes, and how.
struct CyclesRequest {
  static constexpr const char* lengths = "lengths";  // length_y/length_y0 − length_x/length_x0

  std::string csv;                      // a file, or empty for a run:
  std::string directory;                // of the run
  std::string probe;                    // its series; empty: the first that has the columns
  std::string strain = lengths;         // a column, or lengths
  std::string load;                     // a column; empty: none
  double period = 0;                    // (s) 0: that of the run; without one, each row is a cycle
  std::optional<double> first_minimum;  // (s) nullopt: the beginning of the stage, or the first row
  std::size_t drop = 0;                 // the lengths refer to the minimum of this number
};

// When a load was cycled, as the record of its run says.
struct LoadTimes {
  CycleTimes times;  // period 0: the load has none
  double end = 0;    // (s)
};

// A series and its cycles.
struct CyclesSource {
  std::filesystem::path file;
  std::string strain, strain_unit, load, load_unit;
  double period = 0;                  // (s) 0: each row is a cycle
  std::vector<double> minimum_times;  // (s)
  CycleSeries series;
  double stage_period = 0;   // (s) of the stage of the run; 0: none, or not looked for
  std::string status = {};   // why the run stopped before the end of its stage; empty: it did not
  std::size_t cut_line = 0;  // TimeSeries::cut_line
};

// The file that is asked for. Throws Error for a directory that has no series with the columns.
std::filesystem::path series_file(const CyclesRequest& request);

// Reads the cycles of a series. load: of its run, for what the request leaves open. Throws Error with file
// and cure.
CyclesSource read_cycles(const std::filesystem::path& file, const CyclesRequest& request,
                         const std::optional<LoadTimes>& load);

}  // namespace scree::cycles
