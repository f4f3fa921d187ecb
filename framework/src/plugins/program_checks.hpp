#pragma once

#include <optional>
#include <vector>

#include <scree/error.hpp>

namespace scree {

// What is wrong with the numbers of a function of time (see program.hpp), which plug-ins read unchecked,
// without a place; nothing if they are valid.
std::optional<Error> program_problem(const std::vector<double>& data);

}  // namespace scree
