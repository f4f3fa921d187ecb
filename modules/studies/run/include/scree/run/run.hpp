#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <scree/ranks.hpp>
#include <scree/run/input_hashes.hpp>
#include <scree/run/verdict.hpp>
#include <scree/scenario/plan.hpp>
#include <scree/simulation.hpp>

namespace scree::run {

// Progress of a run, for progress bars.
struct Progress {
  std::optional<double> share;  // 0 to 1; absent while this stage or a later one ends by a condition
  double wall_time = 0;         // (s) since the start
  double time = 0;              // (s) simulated
  std::string stage;
  std::size_t stage_number = 1, stages = 1;
  std::string conditions;  // see StageRunner::status()
};

struct RunOptions {
  std::filesystem::path out;  // empty: runs/<stem of the scenario>, numbered if it exists
  bool overwrite = false;
  unsigned threads = 1;
  Ranks* ranks = nullptr;  // that compute the scene together with this process, the first of them; or null
  std::function<void(const Simulation&)> on_start;     // called once, when the directory is ready
  std::function<void(const Progress&)> on_progress;    // called about five times per second
  std::function<void(const std::string&)> on_warning;  // one line "<what>; <cure>"
  const std::atomic<bool>* stop = nullptr;             // set by Ctrl-C: the run saves its results and ends
};

// A stage of a run that has begun.
struct StageResult {
  std::string name;
  double start = 0, end = 0;  // (s) simulated
  std::uint64_t first_step = 0, steps = 0;
  std::string ended;  // "duration", "condition", "at_most", "interrupted", "failed"; "running" until then
};

struct RunResult {
  std::filesystem::path directory;
  bool interrupted = false;
  double wall_time = 0;                  // (s) from the first step to the last file
  double output = 0;                     // (s) of it for samples, files, pictures, charts and states
  double state_output = 0;               // (s) of that for states
  std::uint64_t states = 0;              // written
  double particle_steps_per_second = 0;  // in the rest of it
  std::vector<StageResult> stages;
  InputHashes inputs;                 // of the files that it began from
  std::vector<std::string> warnings;  // "<what>; <cure>"
  std::vector<std::pair<std::string, double>> quantities;
  std::uint64_t state_hash = 0;
  std::vector<Verdict> verdicts;
};

// Runs a plan and writes its directory. Throws Error (bad_input) before anything is written; Error (blow_up),
// or Error (failure) if an end condition is not reached in time or the disk is full; results so far are kept.
RunResult run_plan(const scenario::Plan& plan, const RunOptions& options);

// What changes in a run that goes on.
struct ResumeChanges {
  std::vector<std::string> overrides;                     // "key=value" of the lengths of stages
  std::optional<double> until;                            // (s) end of the last stage
  std::optional<std::optional<double>> checkpoint_every;  // see CheckpointPlan::every
  std::string from = {};  // the stage from whose end it goes on; empty: from the latest state
};

// Goes on with the run in the directory options.out, from the latest of its states that can be read, to the
// same bits as if it had never stopped. Results are dropped only with options.overwrite: all of them if there
// is no state, those after the stage `from`. Throws Error as run_plan() does; nothing is changed if the
// status is bad_input.
RunResult resume_run(const RunOptions& options, const ResumeChanges& changes, PluginHost& host,
                     const scenario::StudyTables& studies = {});

}  // namespace scree::run
