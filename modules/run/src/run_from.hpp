#pragma once

#include <scree/run/run.hpp>
#include <scree/run/run_directory.hpp>
#include <scree/state.hpp>

namespace scree::run {

// Whether a run may take another directory; one that goes on may not, also where it begins anew.
enum class Place { free, same };

// Runs a plan in its directory. state: that from which the run goes on, or null for a new run.
RunResult run_from(const State* state, const scenario::Plan& plan, const RunOptions& options,
                   RunDirectory& directory, Place place);

}  // namespace scree::run
