#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <scree/error.hpp>
#include <scree/files/directory_lock.hpp>
#include <scree/run/written_files.hpp>

namespace scree::run {

// The directory of one run, study or campaign, used by one process at a time. That of a
// run has series/, snapshots/, images/, charts/, scenario.toml, run.json, final_packing.csv. What a run or
// study writes is listed in written.txt, and nothing else is ever removed; a campaign removes nothing.
class RunDirectory {
 public:
  enum class Kind { run, accuracy, campaign, spectrum, modes, quasi_static };
  // What becomes of a run, study or campaign that is in the directory already.
  enum class Existing { refuse, replace, keep };
  // File for the terminal output of a run, written by its caller; not counted as foreign, and not removed.
  static constexpr const char* log_name = "log.txt";

  // Checks, without changing anything, that the directory can be used. Throws Error if it contains a run that
  // is to be refused, or foreign files, or cannot be created.
  RunDirectory(std::filesystem::path path, Existing existing, Kind kind = Kind::run);
  // Takes the first of path, path-2, path-3, ... that does not exist.
  static RunDirectory numbered(const std::filesystem::path& path, Kind kind = Kind::run);

  // That of results of a scenario, taken: `out`, or without it the first of default_for() that does not
  // exist. Throws Error as the constructor and take() do, and if replacing what is there would remove one of
  // the inputs.
  static RunDirectory of_results(const std::filesystem::path& out, bool overwrite,
                                 const std::filesystem::path& scenario,
                                 const std::vector<std::filesystem::path>& inputs, Kind kind = Kind::run);

  // Creates it if it is not there, and locks it until this object or the process ends; if it is empty then,
  // it is removed again. The runs of a campaign hold its lock too. Throws Error if another process uses it.
  void take();
  // Throws Error if one of these files is listed, so that create() would remove it.
  void protect(const std::vector<std::filesystem::path>& inputs) const;
  // Takes it, and removes the files of an earlier run that is to be replaced. Throws Error (failure) if one
  // cannot be removed.
  void create();
  // Warns if other processes cannot be kept out, on a file system without locks. After take().
  void report_lock(const std::function<void(const std::string&)>& on_warning) const;
  // Throws Error (failure) if the directory is no longer where it was taken: it was moved or removed, or its
  // lock was.
  void check_in_place() const;
  // create(), and then `open`, which writes the first files. If that fails, what was written is removed
  // again.
  void begin(const std::function<void()>& open);
  // From now on what is there already is replaced.
  void replace() { existing_ = Existing::replace; }
  // Removes what is listed, as far as it can be, and the directories that were made for it.
  void discard();

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path series() const { return path_ / "series"; }

  // Lists a file that is about to be written; returns its path. After create(), as the next two. Throws the
  // Error of check_in_place().
  std::filesystem::path add(const std::string& name) const;
  WrittenFiles& written() const { return *written_; }
  // Lists a file (of a campaign: does not), writes it under a temporary name, then renames it, so that
  // readers never see an incomplete file.
  void write_file(const std::string& name, const std::string& text) const;

  // runs/<stem of the scenario>, runs/<stem>-accuracy, runs/<stem>-spectrum, runs/<stem>-modes,
  // runs/<stem>-quasi-static, campaigns/<stem>.
  static std::filesystem::path default_for(const std::filesystem::path& scenario, Kind kind = Kind::run);

 private:
  RunDirectory(std::filesystem::path path, Kind kind, files::DirectoryLock lock);
  void check() const;

  std::filesystem::path path_;
  Existing existing_;
  Kind kind_;
  std::optional<files::DirectoryLock> lock_;
  std::unique_ptr<WrittenFiles> written_;  // from create() on, but of a campaign
};

// Throws the Error (failure) of a file of a run that cannot be written; code: as errno, 0 if unknown.
[[noreturn]] void throw_unwritable(const std::filesystem::path& path, int code = 0);

}  // namespace scree::run
