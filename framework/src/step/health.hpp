#pragma once

#include <scree/simulation.hpp>

namespace scree {

// The scene, if the kernel can set it up; else throws Error naming the body or number and the cure.
const Scene& checked(const Scene& scene);

// Finds what went wrong in a simulation that crossed a limit and throws Error(blow_up) with the particle or
// contact, the time, and what to change.
[[noreturn]] void report_blow_up(const Simulation& simulation, double speed_limit);

}  // namespace scree
