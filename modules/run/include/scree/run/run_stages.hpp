#pragma once

#include <functional>
#include <string>
#include <vector>

#include <scree/simulation.hpp>
#include <scree/stage.hpp>

namespace scree::run {

// Takes a simulation through all stages, without probes and output. `proceed` is polled in each step, `on_progress` called
// every thousand steps with the share of the stage and its name. Throws Error (interrupted) if `proceed` ends it, or as
// Simulation::step().
void run_stages(Simulation& simulation, const std::vector<Stage>& stages,
                const std::function<bool()>& proceed,
                const std::function<void(double share, const std::string& stage)>& on_progress);

}  // namespace scree::run
