#pragma once

#include <scree/simulation.hpp>

namespace scree {

// Returns the scene if it is valid; otherwise throws Error with the body or number at fault and a remedy.
const Scene& checked(const Scene& scene);

// Finds the cause in a simulation that exceeded a limit; speed_limit in m/s. Throws Error(blow_up) with the
// particle or contact, the time and a remedy.
[[noreturn]] void report_blow_up(const Simulation& simulation, double speed_limit);

// Throws Error if a wall that was absent is there and has centres of bodies behind it: they would be pushed
// out by overlaps larger than their radii.
void check_appeared(const Particles& particles, const Boundaries& boundaries,
                    const std::vector<std::uint8_t>& absent_before);

}  // namespace scree
