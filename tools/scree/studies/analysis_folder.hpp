#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scree::tool {

// Creates a folder and those above it. Throws Error if it cannot.
void create_folder(const std::filesystem::path& folder);

// The folder of the results of an analysis: that of the analysed file, or --out. Files of the same names are
// replaced if they are results of the same file.
class AnalysisFolder {
 public:
  // source: the analysed file; what: in a message, such as "the cycles"; names: of all results. Throws Error
  // if a result would replace the source.
  AnalysisFolder(std::filesystem::path folder, std::filesystem::path source, std::string what,
                 std::vector<std::string> names);

  // recorded: the file that the present results are of; empty: none. Throws Error if there are results of
  // another file.
  void refuse_others(const std::filesystem::path& recorded) const;

  void create() const { create_folder(folder_); }

  const std::filesystem::path& path() const { return folder_; }
  // The path of a result. In the directory of a run it is listed in written.txt, and removed with the run.
  std::filesystem::path path_of(const std::string& name) const;

 private:
  std::filesystem::path folder_, source_;
  std::vector<std::string> names_;
};

}  // namespace scree::tool
