#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <scree/campaign/outcome.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::campaign {

// Puts a folder at the front of the environment variable SCREE_STATE_PATH of this process and the processes
// that it starts, until the end of this object. Not thread-safe.
class StatePath {
 public:
  // Throws Error if the path contains ':', which separates folders.
  explicit StatePath(const std::filesystem::path& folder);
  ~StatePath();
  StatePath(const StatePath&) = delete;
  StatePath& operator=(const StatePath&) = delete;

 private:
  std::optional<std::string> before_;
};

// The directory of a campaign: one run directory per point, table.csv, means.csv, campaign.json, prepare/
// with one per preparation, and tasks/ with what was given to a batch system. It is locked by one campaign at
// a time, and by the runs it started until the last of them has ended. Runs of tasks lock their own
// directories. States of preparations are found by this process and its children while this object exists.
class CampaignDirectory {
 public:
  static constexpr const char* preparation_folder = "prepare";  // with a run directory for each preparation
  static constexpr const char* tasks_folder = "tasks";
  static constexpr const char* final_state = "final_state.h5";  // of a preparation; points begin from it

  // alone: takes the directory, which is created if it does not exist, and removed at the end if it is empty
  // then. Else nothing is changed. Throws Error if it contains other files or another campaign, cannot be
  // created or, alone, is in use.
  CampaignDirectory(std::filesystem::path path, const Campaign& campaign, bool alone);

  const run::RunDirectory& files() const { return files_; }
  std::filesystem::path run(const Point& point) const { return files_.path() / point.name; }
  std::filesystem::path log(const Point& point) const { return run(point) / run::RunDirectory::log_name; }

  // Outcome of each point so far, and of each preparation. Throws Error if settings do not fit the scenario.
  std::vector<Outcome> outcomes(const Campaign& campaign, const PluginHost& host) const;
  std::vector<Outcome> preparations(const Campaign& campaign, const PluginHost& host) const;
  // Outcome of one point. A run recorded as running counts as interrupted if no process writes it. A
  // preparation that has finished without a final state counts as changed.
  Outcome outcome(const Campaign& campaign, const Point& point, const PluginHost& host) const;
  // Whether a process has the directory of the run, also on another computer where the file system has locks
  // for all of them.
  bool is_written(const Point& point) const;
  // Whether the run of a point has a state from which it can go on.
  bool has_state(const Point& point) const;
  // Names of runs whose values are no longer part of the campaign.
  std::vector<std::string> leftovers(const Campaign& campaign) const;

 private:
  bool has_final_state(const Point& point) const;

  run::RunDirectory files_;
  std::optional<StatePath> states_;  // of the preparations
};

}  // namespace scree::campaign
