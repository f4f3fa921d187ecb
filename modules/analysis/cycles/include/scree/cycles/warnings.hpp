#pragma once

#include <string>
#include <vector>

#include <scree/cycles/classification.hpp>
#include <scree/cycles/cycles_source.hpp>

namespace scree::cycles {

// Warns of a run that did not finish, a period that is a multiple of the load's, and a last line that may be
// cut off.
std::vector<std::string> warnings_of_source(const CyclesSource& source);

// Warns if the load at the minima differs so much from cycle to cycle that the strain does too, as with a
// period that is not exactly the load's; else empty. drop: cycles before the first that counts.
std::string warning_of_loads(const CyclesSource& source, const Classification& found, std::size_t drop);

}  // namespace scree::cycles
