#pragma once

#include "sampler.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <scree/run/run.hpp>
#include <scree/run/session.hpp>
#include <scree/simulation.hpp>
#include <scree/state_transfer.hpp>

namespace scree::run {

// What a run has to report: its stages, verdicts and numbers, in run.json.
class Results {
 public:
  Results(const scenario::Plan& plan, const RunOptions& options, Session& session,
          const Simulation& simulation);

  // The stages so far and warnings, which go on in a run that is resumed.
  void transfer(const StateTransfer& state);
  // Takes wall times and the number of states, which differ between runs of one scene and therefore are in no
  // state, from the run.json of the run that goes on.
  void go_on_with_times();

  // `how` the stage before ended, if there is one, as in StageResult.
  void begin_stage(const std::string& name, const char* how);
  void end_stage(const char* how);
  std::size_t stages() const { return result_.stages.size(); }
  // Counts a state that was written in a time (s).
  void count_state(double seconds) { ++result_.states, result_.state_output += seconds; }
  void judge(const Sampler& sampler);
  // Takes the quantities and the hash of the present time, for the next records.
  void take_quantities();
  // The entries of run.json, with the times up to now.
  nlohmann::ordered_json record();

  // After the last record.
  RunResult result() const;

 private:
  const scenario::Plan& plan_;
  const RunOptions& options_;
  Session& session_;
  const Simulation& simulation_;
  RunResult result_;
  double wall_time_before_ = 0, output_before_ = 0;  // (s) until the state from which the run goes on
};

// What a run that goes on takes from the run.json of its directory; the defaults below if the file cannot be
// read.
struct Recorded {
  std::string status;
  double wall_time = 0, output = 0, state_output = 0;  // (s)
  std::uint64_t states = 0;
  std::vector<std::string> warnings = {};
  std::string scenario = {};
  std::vector<std::pair<std::string, std::uint64_t>> stages = {};  // names and steps of those that have begun
};
Recorded recorded_in(const std::filesystem::path& directory);

// Writes the bodies as a packing for the key `file` of [particles]; writes nothing if a value is not finite.
void write_final_packing(const Simulation& simulation, const std::filesystem::path& path);

}  // namespace scree::run
