#pragma once

#include <string>

#include <scree/scenario/run.hpp>

namespace scree::scenario {

// The text of run.json. `status`: "running", "finished", "interrupted" or "failed"; `error` is empty but for
// failed.
std::string run_record(const Plan& plan, const RunOptions& options, const RunResult& result,
                       const Simulation& simulation, const std::string& status, const std::string& error);

}  // namespace scree::scenario
