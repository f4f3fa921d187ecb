#pragma once

#include <map>
#include <string>
#include <vector>

#include <scree/campaign/execution.hpp>

namespace scree::campaign {

// One row per point: run, case, the keys that vary, seed, status, expectations, expectations_met, warnings
// (separated by " | "), then every quantity of the finished runs.
std::string table_csv(const Campaign& campaign, const std::vector<Outcome>& outcomes);

// One row per group of points that differ only in their seed: case, the keys that vary, number of finished
// runs, then <quantity>_mean and <quantity>_standard_error (empty for a single run) of every quantity.
std::string means_csv(const Campaign& campaign, const std::vector<Outcome>& outcomes);

// Settings and outcomes of all points and preparations, as JSON.
std::string campaign_json(const Campaign& campaign, const Execution& execution);

// Writes table.csv, campaign.json and, with several seeds, means.csv. Throws Error (failure) if it cannot.
void write_report(const Campaign& campaign, const Execution& execution, const CampaignDirectory& directory);

// Writes report.html of what write_report() has written. Throws Error (failure) if it cannot.
void write_page(const CampaignDirectory& directory);

// For a terminal: varied keys, preparations with their wall times, number of finished runs, runs that went on
// from a state, expectations, failed runs with their reasons, runs with warnings.
std::string text_report(const Campaign& campaign, const Execution& execution);

// For a terminal: runs that are no longer part of the campaign; empty if there are none.
std::string leftover_report(const std::vector<std::string>& names);

// For a terminal: each preparation and each point with its status, and what is noted of its name.
std::string list_report(const Campaign& campaign, const std::vector<Outcome>& preparations,
                        const std::vector<Outcome>& outcomes,
                        const std::map<std::string, std::string>& notes = {});

// For a terminal: runs that were stopped, with the last line of the log of each.
std::string stopped_report(const Campaign& campaign, const std::vector<Outcome>& outcomes);

}  // namespace scree::campaign
