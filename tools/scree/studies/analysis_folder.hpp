#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scree::tool {

// Throws Error if it cannot be created.
void create_folder(const std::filesystem::path& folder);

// Where the analysis of a file writes: beside it, or where --out says. Earlier files of the same names are replaced
// if they are of the same file.
class AnalysisFolder {
 public:
  // what: is written, such as "the cycles"; names: of all files. Throws Error if one of them is the file that is
  // analysed.
  AnalysisFolder(std::filesystem::path folder, std::filesystem::path source, std::string what,
                 std::vector<std::string> names);

  // Throws Error if one of the files is there already and not of this source, but of the one recorded, or of none.
  void refuse_others(const std::filesystem::path& recorded) const;

  void create() const { create_folder(folder_); }

  const std::filesystem::path& path() const { return folder_; }
  // Where a file is written. In the directory of a run, it is listed with the files of the run, and removed with them.
  std::filesystem::path path_of(const std::string& name) const;

 private:
  std::filesystem::path folder_, source_;
  std::vector<std::string> names_;
};

}  // namespace scree::tool
