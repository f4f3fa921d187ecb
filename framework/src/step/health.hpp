#pragma once

#include <scree/simulation.hpp>

namespace scree {

// Returns the scene if it is valid; otherwise throws Error with the body or number at fault and a remedy.
const Scene& checked(const Scene& scene);

// Finds the cause in a simulation that exceeded a limit; speed_limit in m/s. Throws Error(blow_up) with the
// particle or contact, the time and a remedy.
[[noreturn]] void report_blow_up(const Simulation& simulation, double speed_limit);

}  // namespace scree
