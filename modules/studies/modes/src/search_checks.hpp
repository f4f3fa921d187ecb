#pragma once

#include <scree/modes/vibration.hpp>
#include <scree/response/undamped_system.hpp>

namespace scree::modes {

// Throws Error "<what>; <cure>" if modes are to be counted at frequencies whose squares are infinite.
void check_density(const VibrationOptions& options);

// Throws Error "<what>; <cure>" if there are no modes at the frequencies at which they are to be looked for,
// or too many for the memory of the computer.
void check_search(const response::UndampedSystem& system, const VibrationOptions& options);

}  // namespace scree::modes
