#pragma once

#include "cycles_source.hpp"

#include <string>
#include <vector>

#include <scree/cycles/classification.hpp>

namespace scree::tool {

// Why cycles may not be what they seem: a run that did not finish, a period that is a multiple of the load's, and one that is not the load's,
// so that the load at the minima drifts. drop: cycles before the first that counts.
std::vector<std::string> cycles_warnings(const CyclesSource& source, const cycles::Classification& found,
                                         std::size_t drop);

}  // namespace scree::tool
