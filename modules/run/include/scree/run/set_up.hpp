#pragma once

#include <memory>
#include <optional>
#include <string>

#include <scree/scenario/plan.hpp>
#include <scree/simulation.hpp>

namespace scree::run {

// The simulation of a plan at t = 0. Throws Error (bad_input), placed in the file, where the bodies overlap
// beyond the limit, move too fast, or do not fit a periodic length, a step is too long, or a probe looks at
// what is not there.
std::unique_ptr<Simulation> set_up(const scenario::Plan& plan, unsigned threads = 1);

// One line for people: the step, and how many are in the shortest contact; says so if they are few.
std::string describe_step(const Simulation& simulation);

// What is wrong with the step, "<problem>; <cure>", if it is longer than something in the scene allows: see
// step_guard.hpp.
std::optional<std::string> step_problem(const Simulation& simulation);

// Throws Error (blow_up) if the plan keeps a step guard and the step has become too long, as a stage may make
// it.
void check_step(const scenario::Plan& plan, const Simulation& simulation);

}  // namespace scree::run
