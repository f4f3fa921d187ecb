#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <scree/cycles/cycle_series.hpp>

namespace scree::tool {

// Which series `scree cycles` takes, and how.
struct CyclesRequest {
  static constexpr const char* lengths = "lengths";  // length_y/length_y0 − length_x/length_x0

  std::string csv;  // a file; or empty:
  std::string directory,
      probe;  // a run directory and a probe; no probe: the first whose series has the columns
  std::string strain = lengths;         // a column, or lengths
  std::string load;                     // a column; empty: none
  double period = 0;                    // (s) 0: that of the run; if it has none, one row is one cycle
  std::optional<double> first_minimum;  // (s) none: the beginning of the stage, or the first row
  std::size_t drop = 0;                 // the lengths refer to the minimum of this number
};

// A series and its cycles.
struct CyclesSource {
  std::filesystem::path file;
  std::string strain, strain_unit, load, load_unit;
  double period = 0;                  // (s) 0: one row is one cycle
  std::vector<double> minimum_times;  // (s)
  cycles::CycleSeries series;
  double stage_period = 0;   // (s) of the stage of the run; 0: none, or not looked for
  std::string status = {};   // why the cycles of the run ended before their stage; empty: they did not
  std::size_t cut_line = 0;  // signals::TimeSeries
};

// Throws Error with file and cure.
CyclesSource read_cycles(const CyclesRequest& request);

}  // namespace scree::tool
