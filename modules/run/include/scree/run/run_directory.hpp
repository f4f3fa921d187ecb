#pragma once

#include <filesystem>
#include <string>

#include <scree/error.hpp>

namespace scree::run {

// The directory of one run, study or campaign. That of a run has series/, snapshots/, images/, charts/,
// scenario.toml, run.json, final_packing.csv.
class RunDirectory {
 public:
  enum class Kind { run, study, campaign };
  // File for the terminal output of a run, written by its caller; not counted as foreign, and not removed.
  static constexpr const char* log_name = "log.txt";

  // Checks, without changing anything, that the directory can be used. Throws Error if it contains a run
  // (unless `overwrite`) or foreign files, or cannot be created.
  RunDirectory(std::filesystem::path path, bool overwrite, Kind kind = Kind::run);

  // Creates it empty; an earlier run is removed only now. A campaign keeps the runs in its directory.
  void create() const;
  // Removes it, and the parent directories that create() made.
  void discard() const;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path series() const { return path_ / "series"; }
  std::filesystem::path snapshots() const { return path_ / "snapshots"; }
  std::filesystem::path images() const { return path_ / "images"; }
  std::filesystem::path charts() const { return path_ / "charts"; }

  // Writes a file under a temporary name, then renames it, so that readers never see an incomplete file.
  void write_file(const std::string& name, const std::string& text) const;

  // runs/<stem of the scenario>, with -2, -3, ... appended if it exists; campaigns/<stem>.
  static std::filesystem::path default_for(const std::filesystem::path& scenario, Kind kind = Kind::run);

 private:
  std::filesystem::path path_, existing_;  // existing_: the part of the path that existed before
  Kind kind_;
};

// Error for a file of a run that cannot be written; code: as errno, 0 if unknown.
Error unwritable(const std::filesystem::path& path, int code = 0);

}  // namespace scree::run
