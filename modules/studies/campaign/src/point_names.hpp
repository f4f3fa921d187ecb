#pragma once

#include <vector>

#include <scree/campaign/campaign.hpp>

namespace scree::campaign {

// Names the directory of each point, such as "case=soft,static_friction=0.1,seed=3". A name depends only on
// the settings of the point, unless another point would get the same name.
void name_points(const Campaign& campaign, std::vector<Point>& points);

}  // namespace scree::campaign
