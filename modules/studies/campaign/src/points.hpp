#pragma once

#include <vector>

#include <scree/campaign/campaign.hpp>

namespace scree::campaign {

// Number of runs of the product, or `max` + 1 if there are more than `max`.
std::size_t count_points(const Campaign& campaign, std::size_t max);

// All points of the product of cases, parameters and seeds, seeds fastest, with names.
std::vector<Point> make_points(const Campaign& campaign, const std::string& seeds_place);

}  // namespace scree::campaign
