#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace scree::campaign {

// Quantities "<probe>.<column>.<statistic>" from the series of a run, those left out that are not there.
std::vector<std::pair<std::string, double>> collected(const std::filesystem::path& directory,
                                                      const std::vector<std::string>& names);

}  // namespace scree::campaign
