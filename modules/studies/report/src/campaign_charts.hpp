#pragma once

#include "campaign_table.hpp"
#include "figures.hpp"

namespace scree::report {

// Draws each quantity over each key that is a number: means over the seeds with bars of their standard
// errors, a curve for each combination of the other keys.
void add_campaign_charts(const CampaignTable& table, Figures& figures);

}  // namespace scree::report
