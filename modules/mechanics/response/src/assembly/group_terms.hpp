#pragma once

#include <vector>

#include <scree/simulation.hpp>

namespace scree::response {

// Throws Error if a group moves bodies, or loads them as a function of time: here supports are at rest.
void check_groups(const Simulation& simulation);
// Components in which bodies that are not fixed are held, for DegreesOfFreedom; empty if there are none.
std::vector<freedom::Mask> held_components(const Particles& particles);

}  // namespace scree::response
