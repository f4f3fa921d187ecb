#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <scree/run/run.hpp>

namespace scree::run {

// Text of run.json. `status`: "running", "finished", "interrupted" or "failed"; `error`: empty unless failed.
std::string run_record(const scenario::Plan& plan, const RunOptions& options, const RunResult& result,
                       const Simulation& simulation, const std::string& status, const std::string& error);

// What a run that goes on takes from the run.json of its directory; as here if that cannot be read.
struct Recorded {
  std::string status;
  double wall = 0, output = 0, state_output = 0;  // (s)
  std::uint64_t states = 0;
  std::vector<std::string> warnings = {};
  std::string scenario = {};
};
Recorded recorded_in(const std::filesystem::path& directory);

}  // namespace scree::run
