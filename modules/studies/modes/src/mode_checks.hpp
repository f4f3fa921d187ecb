#pragma once

#include <string>
#include <vector>

#include <scree/modes/vibration.hpp>
#include <scree/response/undamped_system.hpp>

namespace scree::modes {

// Throws Error "<what>; <cure>" if modes are to be counted at frequencies whose squares are infinite.
void check_density(const VibrationOptions& options);

// Throws Error "<what>; <cure>" if there are no modes at the frequencies at which they are to be looked for,
// or too many for the memory of the computer.
void check_search(const response::UndampedSystem& system, const VibrationOptions& options);

// What is to be said of the modes of a packing: "<what>; <cure>". of_full_stiffness: as in
// response::FoundModes. residual_limit: above which frequencies are approximate.
std::vector<std::string> mode_warnings(const Vibration& vibration, bool of_full_stiffness,
                                       double residual_limit);

}  // namespace scree::modes
