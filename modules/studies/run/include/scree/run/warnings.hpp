#pragma once

#include <string>
#include <vector>

#include <scree/scenario/plan.hpp>
#include <scree/simulation.hpp>

namespace scree::run {

// Two bodies, or a body and a wall, that overlap.
struct LargestOverlap {
  double ratio = 0;    // overlap / smaller radius; 0: nothing overlaps
  std::string bodies;  // "particle 3 and particle 7", "particle 3 and wall box.x_low"
};

// The pair whose overlap is the largest share of the smaller radius, in the present state.
LargestOverlap largest_overlap(const Simulation& simulation);

// Each warning is one line "<what>; <cure>" without its place.

// Of a scene at t = 0: time step, integrator, grazing impacts, initial overlaps, slow builds of plug-ins,
// what was not taken from files.
std::vector<std::string> start_warnings(const scenario::Plan& plan, const Simulation& simulation);

// Of the results so far: energy balance and energy created by contact laws.
std::vector<std::string> result_warnings(const Simulation& simulation);

}  // namespace scree::run
