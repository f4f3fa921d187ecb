#pragma once

#include <vector>

#include <scree/campaign/campaign.hpp>

namespace scree::campaign {

// How many runs the product has, at most one more than `most`.
std::size_t count_points(const Campaign& campaign, std::size_t most);

// The product of cases, parameters and seeds, seeds fastest, with names.
std::vector<Point> make_points(const Campaign& campaign, const std::string& seeds_place);

}  // namespace scree::campaign
