#pragma once

#include <string>
#include <vector>

#include <scree/campaign/outcome.hpp>

namespace scree::campaign {

// Names of the quantities of all runs, in order of first appearance.
std::vector<std::string> number_names(const std::vector<Outcome>& outcomes);
// NaN if the run has no quantity of this name.
double number_of(const Outcome& outcome, const std::string& name);

// Columns that identify a point, without its seed: "case" if there are cases, and the keys that vary.
std::vector<std::string> point_header(const Campaign& campaign);
// Empty if the case of the point does not set a key.
std::vector<std::string> point_cells(const Campaign& campaign, const Point& point);

void append(std::vector<std::string>& cells, const std::vector<std::string>& more);

}  // namespace scree::campaign
