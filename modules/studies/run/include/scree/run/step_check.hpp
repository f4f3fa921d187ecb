#pragma once

#include <optional>
#include <string>

#include <scree/error.hpp>
#include <scree/scenario/plan.hpp>
#include <scree/simulation.hpp>

namespace scree::run {

// One line for people: the time step, and the number of steps per shortest contact.
std::string describe_step(const Simulation& simulation);

// Returns "<what>; <cure>" if the time step is unstable or its errors are large.
std::optional<std::string> step_warning(const Simulation& simulation);

// Error without a place if the time step exceeds the limit of the scene: see step_guard.hpp.
std::optional<Error> step_problem(const Simulation& simulation);

// Throws Error (blow_up) if the plan has a step guard and the time step is too long; called at each stage,
// which may change the limit.
void check_step(const scenario::Plan& plan, const Simulation& simulation);

}  // namespace scree::run
