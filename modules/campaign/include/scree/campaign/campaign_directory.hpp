#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <scree/campaign/outcome.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::campaign {

// The directory of a campaign: one run directory per point, table.csv, means.csv, campaign.json. One campaign
// at a time writes there; the runs that it started hold the directory too, until the last has ended.
class CampaignDirectory {
 public:
  // Touches nothing. Throws Error if it holds other files or another campaign, or cannot be created; if it is
  // in use, only where `alone`.
  CampaignDirectory(std::filesystem::path path, const Campaign& campaign, bool alone);
  ~CampaignDirectory();
  CampaignDirectory(const CampaignDirectory&) = delete;
  CampaignDirectory& operator=(const CampaignDirectory&) = delete;

  // Creates it where it is not there. Throws Error if another campaign was faster.
  void create();

  const run::RunDirectory& files() const { return files_; }
  std::filesystem::path run(const Point& point) const { return files_.path() / point.name; }
  std::filesystem::path log(const Point& point) const { return run(point) / run::RunDirectory::log_name; }

  // What is there of each point. Throws Error where the settings of one do not fit the scenario.
  std::vector<Outcome> outcomes(const Campaign& campaign) const;
  // The same of one; a run said to be running has been killed unless somebody uses the directory.
  Outcome outcome(const Campaign& campaign, const Point& point) const;
  // Runs of values that the campaign no longer has, by name.
  std::vector<std::string> leftovers(const Campaign& campaign) const;

 private:
  // Whether nobody else uses the directory; true too where it is not there or the file system knows no locks.
  bool take();

  run::RunDirectory files_;
  int lock_ = -1;  // descriptor of the directory, inherited by the runs
  bool in_use_ = false;
};

}  // namespace scree::campaign
