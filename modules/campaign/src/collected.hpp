#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace scree::campaign {

// Values of quantities "<probe>.<column>.<statistic>" from the series of a run; missing ones are omitted.
std::vector<std::pair<std::string, double>> collected(const std::filesystem::path& directory,
                                                      const std::vector<std::string>& names);

}  // namespace scree::campaign
