#pragma once

#include <functional>

#include <scree/error.hpp>
#include <scree/run/run.hpp>
#include <scree/scenario/plan.hpp>

namespace scree::tool {

// What the verbs that run a scenario show on the terminal.

// Calls work with options that show progress and warnings of a run and let Ctrl-C stop it.
run::RunResult with_progress(bool quiet, const std::function<run::RunResult(run::RunOptions)>& work);

// Prints from which tables the bodies of a scene come, a line each.
void print_sources(const scenario::Plan& plan);

// Prints the result of a run. Returns the exit status that it gives.
ExitStatus report_run(const run::RunResult& result, bool quiet);

}  // namespace scree::tool
