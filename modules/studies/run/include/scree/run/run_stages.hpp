#pragma once

#include <functional>
#include <string>

#include <scree/stage.hpp>

namespace scree::run {

// Takes a simulation from its present stage to the start of the stage `end`, without probes and output.
// `proceed` is polled in each step, `on_progress` called every thousand steps with the share of all stages
// and the name of this one. Returns false if `proceed` ends it. Throws Error as Simulation::step().
bool run_stages(StageRunner& runner, std::size_t end, const std::function<bool()>& proceed,
                const std::function<void(double share, const std::string& stage)>& on_progress);

}  // namespace scree::run
