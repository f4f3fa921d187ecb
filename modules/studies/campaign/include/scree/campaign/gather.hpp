#pragma once

#include <scree/campaign/execution.hpp>

namespace scree::campaign {

// What the runs in a directory are now, whoever has made them: a point whose preparation has failed has
// failed with it, one that was refused has failed, and one that no process writes and that is not finished
// has the last line of its log as problem.
Execution gathered(const Campaign& campaign, const CampaignDirectory& directory, const PluginHost& host);

}  // namespace scree::campaign
