#pragma once

#include <memory>
#include <optional>

#include <scree/run/run.hpp>
#include <scree/run/run_directory.hpp>
#include <scree/simulation.hpp>
#include <scree/state.hpp>

namespace scree::run {

// Whether a run may take another directory; one that goes on may not, also where it begins anew.
enum class Place { free, same };

// The state from which a run goes on, and the simulation that has it.
struct Resumed {
  const State& state;
  std::unique_ptr<Simulation> simulation;
};

// Runs a plan in its directory. from: where the run goes on; nothing for a new run.
RunResult run_from(std::optional<Resumed> from, const scenario::Plan& plan, const RunOptions& options,
                   RunDirectory& directory, Place place);

}  // namespace scree::run
