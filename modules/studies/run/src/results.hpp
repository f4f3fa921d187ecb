#pragma once

#include "sampler.hpp"
#include "stopwatch.hpp"

#include <string>

#include <scree/run/run.hpp>
#include <scree/run/run_directory.hpp>
#include <scree/simulation.hpp>
#include <scree/state_transfer.hpp>

namespace scree::run {

// What a run has to report: its stages, warnings, verdicts and numbers, in run.json.
class Results {
 public:
  Results(const scenario::Plan& plan, const RunOptions& options, const RunDirectory& directory,
          const Simulation& simulation);

  // The stages so far and warnings, which go on in a run that is resumed.
  void transfer(const StateTransfer& state);
  // Takes wall times and the number of states, which differ between runs of one scene and therefore are in no state, from
  // the run.json of the run that goes on.
  void go_on_with_times();

  void begin_stage(const std::string& name);
  // `how`: "interrupted" or "failed"; empty if the stage has reached its end.
  void end_stage(const std::string& how);
  std::size_t stages() const { return result_.stages.size(); }
  void interrupt() { result_.interrupted = true; }
  bool interrupted() const { return result_.interrupted; }
  void warn(const std::string& line);
  // Warnings that are reported later.
  void note(const std::vector<std::string>& lines);
  // Counts a state that was written in a time (s).
  void count_state(double seconds) { ++result_.states, result_.state_output += seconds; }
  void judge(const Sampler& sampler);
  // Writes run.json. `status` and `error` as in run_record.
  void record(const std::string& status, const std::string& error, const Stopwatch& watch);
  // The same of a run that goes on, with the quantities and the hash of the last record.
  void record_times(const Stopwatch& watch);

  const RunResult& result() const { return result_; }

 private:
  void go_on_from(const InputHashes& before);
  void write(const std::string& status, const std::string& error, const Stopwatch& watch);

  const scenario::Plan& plan_;
  const RunOptions& options_;
  const RunDirectory& directory_;
  const Simulation& simulation_;
  RunResult result_;
  double wall_before_ = 0, output_before_ = 0;  // (s) until the state from which the run goes on
};

}  // namespace scree::run
