#pragma once

#include <memory>
#include <string>

#include <scree/ranks.hpp>
#include <scree/scenario/plan.hpp>
#include <scree/simulation.hpp>
#include <scree/state_transfer.hpp>

namespace scree::run {

// Sets up the simulation of a plan at t = 0. Throws Error (bad_input), with the position in the file, if
// bodies overlap beyond the limit, are too fast or do not fit a periodic length, if the time step is too
// long, or if a probe reads something that does not exist. ranks: that compute the scene together with this
// process, the first of them; or null.
std::unique_ptr<Simulation> set_up(const scenario::Plan& plan, unsigned threads = 1, Ranks* ranks = nullptr);

// The simulation of a plan at t = 0 with the parameters of its last stage, for checks of walls and laws
// before a step is taken; null if they do not fit the bodies there.
std::unique_ptr<Simulation> set_up_with_last_stage(const scenario::Plan& plan);

// The simulation of a state, with the parameters of the stage in which it was saved. stages: as
// StageRunner::save wrote it.
std::unique_ptr<Simulation> resumed(const scenario::Plan& plan, const State& state,
                                    const StateTransfer& stages, unsigned threads, Ranks* ranks = nullptr);

// Throws Error (bad_input) if a plan has no stages, as one for a spectrum may.
void require_stages(const scenario::Plan& plan);

// For people: "200 bodies (25 fixed) in 3D".
std::string describe_bodies(const Simulation& simulation);

}  // namespace scree::run
