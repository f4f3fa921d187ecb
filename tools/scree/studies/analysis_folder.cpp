#include "studies/analysis_folder.hpp"

#include <system_error>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/paths.hpp>
#include <scree/run/written_files.hpp>

namespace scree::tool {

namespace fs = std::filesystem;

void create_folder(const fs::path& folder) {
  std::error_code failed;
  if (!folder.empty()) fs::create_directories(folder, failed);
  if (failed)
    throw Error(
        fmt::format("{}: cannot be created ({}); give another --out", folder.string(), failed.message()));
}

AnalysisFolder::AnalysisFolder(fs::path folder, fs::path source, std::string what,
                               std::vector<std::string> names)
    : folder_(std::move(folder)), source_(std::move(source)), names_(std::move(names)) {
  std::error_code failed;
  for (const std::string& name : names_)
    if (fs::equivalent(folder_ / name, source_, failed))
      throw Error(fmt::format("{}: {} would replace this file; give another directory with --out",
                              source_.string(), what));
}

void AnalysisFolder::refuse_others(const fs::path& recorded) const {
  if (recorded == files::resolved(source_)) return;
  std::error_code failed;
  for (const std::string& name : names_)
    if (fs::exists(folder_ / name, failed))
      throw Error(fmt::format(
          "{}: is there already, {}, and this is of {}; give another directory with --out, or --overwrite",
          (folder_ / name).string(), recorded.empty() ? "and not of a series" : "of " + recorded.string(),
          source_.string()));
}

fs::path AnalysisFolder::path_of(const std::string& name) const {
  const fs::path path = folder_ / name;
  std::error_code failed;
  const bool is_of_run = fs::exists(folder_ / run::WrittenFiles::file_name, failed);
  // WrittenFiles refuses a file that is there and not listed; here it is replaced.
  return is_of_run && !fs::exists(path, failed) ? run::WrittenFiles(folder_).add(name) : path;
}

}  // namespace scree::tool
