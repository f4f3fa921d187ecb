#pragma once

#include "studies/analysis_folder.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <scree/signals/amplitude_spectrum.hpp>
#include <scree/signals/time_series.hpp>

namespace scree::tool {

// The results of `scree spectrum --csv`: amplitudes over frequency, a table of lines and, with pictures, a
// chart. The table of lines names its series in a comment; results of the same series are replaced.
class SpectrumFiles {
 public:
  static constexpr const char* table_name = "spectrum.csv";
  static constexpr const char* lines_name = "lines.csv";
  static constexpr const char* chart_name = "spectrum.png";

  // Throws Error if a table would replace the analysed file and, unless overwriting, for results of another
  // file.
  SpectrumFiles(std::filesystem::path folder, const std::filesystem::path& source, bool overwrite);

  // Creates the folder, writes and prints the names of the files. Lines at given frequencies have no
  // frequency errors. Throws Error.
  void write(const signals::AmplitudeSpectrum& amplitudes, const signals::TimeSeries& series,
             const std::vector<signals::FoundLine>& lines) const;

 private:
  AnalysisFolder folder_;
  std::filesystem::path source_;
};

}  // namespace scree::tool
