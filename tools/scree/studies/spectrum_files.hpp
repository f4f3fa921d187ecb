#pragma once

#include <filesystem>

#include <scree/spectrum/amplitude_spectrum.hpp>
#include <scree/spectrum/time_series.hpp>

namespace scree::tool {

// What `scree spectrum` writes: a table and, with pictures, a chart. Earlier ones are replaced.
class SpectrumFiles {
 public:
  static constexpr const char* table_name = "spectrum.csv";
  static constexpr const char* chart_name = "spectrum.png";

  // Throws Error if the table would replace the file that is analysed.
  SpectrumFiles(std::filesystem::path folder, const std::filesystem::path& source);

  // Creates the folder and prints the names of the files. Throws Error.
  void write(const spectrum::AmplitudeSpectrum& amplitudes, const spectrum::TimeSeries& series) const;

 private:
  std::filesystem::path folder_, source_;
};

}  // namespace scree::tool
