#pragma once

#include <string>
#include <string_view>

namespace scree::state_file {

// A unit of a state as the module `units` of H5MD writes it, factors with signed powers: "kg m^2/s" is "kg
// m+2 s-1", "1/s" "s-1".
std::string h5md_unit(std::string_view unit);
// Back to the form of a state.
std::string state_unit(std::string_view h5md);

}  // namespace scree::state_file
