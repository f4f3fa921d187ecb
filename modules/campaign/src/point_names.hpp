#pragma once

#include <vector>

#include <scree/campaign/campaign.hpp>

namespace scree::campaign {

// Names the directory of each point, such as "case=soft,static_friction=0.1,seed=3". A name depends on what
// the point is made of and not on which others there are, unless it would be theirs too.
void name_points(const Campaign& campaign, std::vector<Point>& points);

}  // namespace scree::campaign
