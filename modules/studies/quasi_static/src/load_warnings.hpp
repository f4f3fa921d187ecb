#pragma once

#include <string>
#include <vector>

#include <scree/quasi_static/follow.hpp>
#include <scree/simulation.hpp>

namespace scree::quasi_static {

// What is to be said of the loads of the last stage before the first increment: "<what>; <cure>". Throws
// Error if a wall is moved otherwise than by loads.
std::vector<std::string> load_warnings(const Simulation& simulation, const FollowedLoad& load,
                                       unsigned increments);

// That the load went on for long while the packing moved; empty if it did not.
std::string dynamics_warning(const FollowedLoad& load);

}  // namespace scree::quasi_static
