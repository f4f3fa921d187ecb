#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <scree/campaign/outcome.hpp>
#include <scree/campaign/state_path.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::campaign {

// The directory of a campaign: one run directory per point, table.csv, means.csv, campaign.json, and prepare/ with one
// per preparation. It is locked by one campaign at a time, and by the runs it started until the last of them has
// ended. States of preparations are found by this process and its children while this object exists.
class CampaignDirectory {
 public:
  // Alone: takes the directory, created if it does not exist, and removed at the end if it is empty then; else
  // changes nothing. Throws Error if it contains other files or another campaign, cannot be created, or, alone, is
  // in use.
  CampaignDirectory(std::filesystem::path path, const Campaign& campaign, bool alone);

  const run::RunDirectory& files() const { return files_; }
  std::filesystem::path run(const Point& point) const { return files_.path() / point.name; }
  std::filesystem::path log(const Point& point) const { return run(point) / run::RunDirectory::log_name; }

  // Outcome of each point so far, and of each preparation. Throws Error if the settings of one do not fit the scenario.
  std::vector<Outcome> outcomes(const Campaign& campaign, const PluginHost& host) const;
  std::vector<Outcome> preparations(const Campaign& campaign, const PluginHost& host) const;
  // Outcome of one point. A run recorded as running counts as interrupted if the directory is not in use; of a
  // preparation, one that has finished without a final state counts as changed.
  Outcome outcome(const Campaign& campaign, const Point& point, const PluginHost& host) const;
  // Whether the run of a point has a state from which it can go on.
  bool has_state(const Point& point) const;
  // Names of runs whose values are no longer part of the campaign.
  std::vector<std::string> leftovers(const Campaign& campaign) const;

 private:
  bool has_final_state(const Point& point) const;

  run::RunDirectory files_;
  std::optional<StatePath> states_;  // of the preparations
  bool in_use_ = false;              // by another campaign
};

}  // namespace scree::campaign
