#pragma once

#include <string>
#include <vector>

#include <scree/campaign/outcome.hpp>

namespace scree::campaign {

// Names of the numbers of all runs, in order of first appearance.
std::vector<std::string> number_names(const std::vector<Outcome>& outcomes);
// Not a number where the run has none of that name.
double number_of(const Outcome& outcome, const std::string& name);

// Columns that tell what a point is, without its seed: "case" where there are cases, and the keys that vary.
std::vector<std::string> point_header(const Campaign& campaign);
// Empty where the case of the point leaves a key alone.
std::vector<std::string> point_cells(const Campaign& campaign, const Point& point);

void append(std::vector<std::string>& cells, const std::vector<std::string>& more);

}  // namespace scree::campaign
