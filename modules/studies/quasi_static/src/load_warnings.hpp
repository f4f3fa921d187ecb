#pragma once

#include <string>
#include <vector>

#include <scree/quasi_static/follow.hpp>
#include <scree/simulation.hpp>

namespace scree::quasi_static {

// Warnings about the loads of the last stage, before the first increment: "<what>; <cure>". Throws
// Error if a wall is moved otherwise than by loads.
std::vector<std::string> load_warnings(const Simulation& simulation, const FollowedLoad& load,
                                       unsigned increments);

// A warning if the load continued for long while the packing moved; else empty.
std::string dynamics_warning(const FollowedLoad& load);

}  // namespace scree::quasi_static
