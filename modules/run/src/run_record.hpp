#pragma once

#include <string>

#include <scree/run/run.hpp>

namespace scree::run {

// Text of run.json. `status`: "running", "finished", "interrupted" or "failed"; `error`: empty unless failed.
std::string run_record(const scenario::Plan& plan, const RunOptions& options, const RunResult& result,
                       const Simulation& simulation, const std::string& status, const std::string& error);

}  // namespace scree::run
