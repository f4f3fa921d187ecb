#pragma once

#include <filesystem>
#include <string>

#include <scree/error.hpp>

namespace scree::run {

// The directory of one run, study or campaign. Of a run: series/, snapshots/, images/, charts/,
// scenario.toml, run.json, final_packing.csv.
class RunDirectory {
 public:
  enum class Kind { run, study, campaign };
  // What the caller of a run may keep of its output in the directory; it is neither foreign nor removed.
  static constexpr const char* log_name = "log.txt";

  // Checks that a run may write there, without touching anything: throws Error if it holds a run already
  // (unless `overwrite`), holds foreign files, or cannot be created.
  RunDirectory(std::filesystem::path path, bool overwrite, Kind kind = Kind::run);

  // Creates it empty; an earlier run is removed only now. A campaign goes on with the runs that it holds.
  void create() const;
  // Removes it again, with the directories above it that create() made.
  void discard() const;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path series() const { return path_ / "series"; }
  std::filesystem::path snapshots() const { return path_ / "snapshots"; }
  std::filesystem::path images() const { return path_ / "images"; }
  std::filesystem::path charts() const { return path_ / "charts"; }

  // Writes a whole file under a temporary name, then renames it, so that a reader never sees half of it.
  void write_file(const std::string& name, const std::string& text) const;

  // runs/<stem of the scenario>, with -2, -3, ... appended until it does not exist; campaigns/<stem>.
  static std::filesystem::path default_for(const std::filesystem::path& scenario, Kind kind = Kind::run);

 private:
  std::filesystem::path path_, existing_;  // existing_: the part of the path that was there before
  Kind kind_;
};

// What is thrown where a file of a run cannot be written.
Error unwritable(const std::filesystem::path& path);

}  // namespace scree::run
