#pragma once

#include <string>
#include <vector>

#include <scree/modes/vibration.hpp>

namespace scree::modes {

// What is to be said of the modes of a packing: "<what>; <cure>". of_full_stiffness: as in
// response::FoundModes. residual_limit: above which frequencies are approximate.
std::vector<std::string> mode_warnings(const Vibration& vibration, bool of_full_stiffness,
                                       double residual_limit);

}  // namespace scree::modes
