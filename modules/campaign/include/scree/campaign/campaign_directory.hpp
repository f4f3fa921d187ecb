#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <scree/campaign/outcome.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::campaign {

// The directory of a campaign: one run directory per point, table.csv, means.csv, campaign.json. It is locked
// by one campaign at a time, and by the runs it started until the last of them has ended.
class CampaignDirectory {
 public:
  // Changes nothing. Throws Error if the directory contains other files or another campaign, cannot be
  // created, or, with `alone`, is in use.
  CampaignDirectory(std::filesystem::path path, const Campaign& campaign, bool alone);
  ~CampaignDirectory();
  CampaignDirectory(const CampaignDirectory&) = delete;
  CampaignDirectory& operator=(const CampaignDirectory&) = delete;

  // Creates it if it does not exist. Throws Error if another campaign has locked it meanwhile.
  void create();

  const run::RunDirectory& files() const { return files_; }
  std::filesystem::path run(const Point& point) const { return files_.path() / point.name; }
  std::filesystem::path log(const Point& point) const { return run(point) / run::RunDirectory::log_name; }

  // Outcome of each point so far. Throws Error if the settings of a point do not fit the scenario.
  std::vector<Outcome> outcomes(const Campaign& campaign) const;
  // Outcome of one point. A run recorded as running counts as interrupted if the directory is not in use.
  Outcome outcome(const Campaign& campaign, const Point& point) const;
  // Names of runs whose values are no longer part of the campaign.
  std::vector<std::string> leftovers(const Campaign& campaign) const;

 private:
  // Locks the directory; false if it is in use. Also true without directory or file locks.
  bool lock();

  run::RunDirectory files_;
  int lock_ = -1;  // descriptor of the directory, inherited by the runs
  bool in_use_ = false;
};

}  // namespace scree::campaign
