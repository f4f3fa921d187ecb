#pragma once

#include "studies/cycles_source.hpp"

#include <string>
#include <vector>

#include <scree/cycles/classification.hpp>

namespace scree::tool {

// That the cycles are of a run that did not finish, and that their period is a multiple of the load's.
std::vector<std::string> warnings_of_source(const CyclesSource& source);

// That the load at the minima differs from cycle to cycle by so much that the strain does too, as where the period is not exactly the load's; empty
// if it does not. drop: cycles before the first that counts.
std::string warning_of_loads(const CyclesSource& source, const cycles::Classification& found,
                             std::size_t drop);

}  // namespace scree::tool
