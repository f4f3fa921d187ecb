#pragma once

#include <string>
#include <vector>

#include <scree/campaign/execution.hpp>

namespace scree::campaign {

// One row per point: run, case, the keys that vary, seed, status, expectations, expectations_met, then every
// number of the runs that have finished.
std::string table_csv(const Campaign& campaign, const std::vector<Outcome>& outcomes);

// One row for each group of points that differ in their seeds alone: case, the keys that vary, runs
// (finished), then <number>_mean and <number>_standard_error (empty for a single run) of every number.
std::string means_csv(const Campaign& campaign, const std::vector<Outcome>& outcomes);

// What was asked for and what is there, as JSON.
std::string campaign_json(const Campaign& campaign, const std::vector<Outcome>& outcomes);

// Writes table.csv, campaign.json and, where there are several seeds, means.csv. Throws Error (failure) where
// it cannot.
void write_report(const Campaign& campaign, const std::vector<Outcome>& outcomes,
                  const CampaignDirectory& directory);

// For a terminal: what varies, what finished, the expectations, the runs that failed with their reasons.
std::string text_report(const Campaign& campaign, const Execution& execution);

// For a terminal: runs that are no longer of the campaign; nothing where there are none.
std::string leftover_report(const std::vector<std::string>& names);

// For a terminal: each point with its state.
std::string list_report(const Campaign& campaign, const std::vector<Outcome>& outcomes);

}  // namespace scree::campaign
