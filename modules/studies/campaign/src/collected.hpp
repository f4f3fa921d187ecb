#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace scree::campaign {

// Values of quantities "<probe>.<column>.<statistic>" from the series of a run. Those of a series that is
// missing or damaged are omitted, and a line "<what>; <cure>" is appended to `damaged`.
std::vector<std::pair<std::string, double>> collected(const std::filesystem::path& directory,
                                                      const std::vector<std::string>& names,
                                                      std::vector<std::string>& damaged);

}  // namespace scree::campaign
