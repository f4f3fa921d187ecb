#pragma once

#include "studies/analysis_folder.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <scree/signals/amplitude_spectrum.hpp>
#include <scree/signals/time_series.hpp>

namespace scree::tool {

// What `scree spectrum --csv` writes: amplitudes over frequency, a table of lines, and with pictures a chart. The
// table of lines begins with a comment that names the series; earlier files of this series are replaced.
class SpectrumFiles {
 public:
  static constexpr const char* table_name = "spectrum.csv";
  static constexpr const char* lines_name = "lines.csv";
  static constexpr const char* chart_name = "spectrum.png";

  // Throws Error if a table would replace the file that is analysed, and, unless they may be overwritten, for files
  // of these names that are not of it.
  SpectrumFiles(std::filesystem::path folder, const std::filesystem::path& source, bool overwrite);

  // Creates the folder and prints the names of the files. Lines that were looked for at given frequencies have no
  // errors of these. Throws Error.
  void write(const signals::AmplitudeSpectrum& amplitudes, const signals::TimeSeries& series,
             const std::vector<signals::FoundLine>& lines) const;

 private:
  AnalysisFolder folder_;
  std::filesystem::path source_;
};

}  // namespace scree::tool
