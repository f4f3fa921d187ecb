#pragma once

#include <string>
#include <vector>

#include <scree/scenario/plan.hpp>
#include <scree/simulation.hpp>

namespace scree::tool {

// "bodies from (0, 0, 0) to (0.1, 0.1, 0.2) m, radii 0.002 to 0.003 m".
std::string extent_of_bodies(const Simulation& simulation);

// The largest wall time of all stages, from steps that are taken for a third of a second: "about 4 days at 15
// M particle-steps/s"; empty if the stages have no length, or the scene ends or fails in these steps.
std::string expected_wall_time(const scenario::Plan& plan, Simulation& simulation);

// Numbers that are likely to be in another unit: "<what>; <cure>".
std::vector<std::string> unusual_numbers(const scenario::Plan& plan);

}  // namespace scree::tool
