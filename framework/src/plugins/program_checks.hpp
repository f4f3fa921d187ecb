#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace scree {

// Checks the numbers of a function of time (see program.hpp), which plug-ins read unchecked. Returns "<problem>;
// <remedy>", or nothing if they are valid.
std::optional<std::string> program_problem(const std::vector<double>& data);

// Values between which a valid one stays.
std::pair<double, double> program_extremes(const std::vector<double>& data);

}  // namespace scree
