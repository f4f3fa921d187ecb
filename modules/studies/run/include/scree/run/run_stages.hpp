#pragma once

#include <functional>
#include <string>

#include <scree/scenario/plan.hpp>
#include <scree/stage.hpp>

namespace scree::run {

// A runner of the stages of a plan, from their start or, with `state`, from where it was saved. If conditions read columns
// of probes it has these probes, without series; the plan must outlive it then.
StageRunner stage_runner(Simulation& simulation, const scenario::Plan& plan);
StageRunner stage_runner(Simulation& simulation, const scenario::Plan& plan, const StateTransfer& state);

// Takes a simulation from its present stage to the start of the stage `end`, without probes and output.
// `proceed` is polled in each step, `on_progress` called every thousand steps with the share of all stages
// and the name of this one. Returns false if `proceed` ends it. Throws Error as Simulation::step().
bool run_stages(StageRunner& runner, std::size_t end, const std::function<bool()>& proceed,
                const std::function<void(double share, const std::string& stage)>& on_progress);

}  // namespace scree::run
