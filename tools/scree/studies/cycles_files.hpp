#pragma once

#include "studies/analysis_folder.hpp"
#include "studies/cycles_source.hpp"
#include "studies/cycles_touching.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <scree/cycles/classification.hpp>

namespace scree::tool {

// The cycles of one series and what they are.
struct CyclesResult {
  std::string name;  // of the run
  CyclesSource source;
  cycles::Classification found;
  std::size_t drop = 0;
  std::optional<Rattlers> rattlers = {};  // if they were looked for
};

// What `scree cycles` writes of one series: a table, a record and, with pictures, a chart. Earlier ones of this series are replaced. In the directory
// of a run they are listed with its files, and removed with them.
class CyclesFiles {
 public:
  static constexpr const char* table_name = "cycles.csv";
  static constexpr const char* record_name = "cycles.json";
  static constexpr const char* chart_name = "cycles.png";

  // Creates the folder. Throws Error if it cannot be, if the table would replace the file that is analysed, and, unless they may be overwritten, for
  // files of these names that are of another series.
  CyclesFiles(std::filesystem::path folder, const std::filesystem::path& source, bool overwrite);

  // Prints the names of the files. Throws Error.
  void write(const CyclesResult& result) const;

 private:
  AnalysisFolder folder_;
};

// What it writes of several: a row for each.
class VerdictsFile {
 public:
  static constexpr const char* file_name = "verdicts.csv";

  // Creates the folder. Throws Error if it cannot be, and, unless it may be overwritten, for a file of this name that is no such table, or that has a
  // run which these results lack.
  VerdictsFile(std::filesystem::path folder, const std::vector<CyclesResult>& results, bool overwrite);

  // Prints the name of the file. Throws Error.
  void write(const std::vector<CyclesResult>& results) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace scree::tool
