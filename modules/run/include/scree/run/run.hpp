#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <scree/scenario/plan.hpp>
#include <scree/simulation.hpp>

namespace scree::run {

// How far a run has come, for progress bars.
struct Progress {
  double share = 0;  // 0 to 1
  double wall = 0;   // (s) since the start
  double time = 0;   // (s) simulated
  std::string stage;
};

struct RunOptions {
  std::filesystem::path out;
  bool overwrite = false;
  unsigned threads = 1;
  std::function<void(const Simulation&)> on_start;     // called once, when the directory is ready
  std::function<void(const Progress&)> on_progress;    // called a few times a second
  std::function<void(const std::string&)> on_message;  // one line for the user
  const std::atomic<bool>* stop = nullptr;             // set by Ctrl-C: the run saves what it has and ends
};

// How an expectation came out.
struct Verdict {
  scenario::Expectation expectation;
  double value = 0;
  bool met = false;
};

struct RunResult {
  std::filesystem::path directory;
  bool interrupted = false;
  double wall = 0;  // (s) of the time loop
  double particle_steps_per_second = 0;
  std::vector<std::pair<std::string, double>> quantities;
  std::uint64_t state_hash = 0;
  std::vector<Verdict> verdicts;
};

// Runs a plan into its directory. Throws Error (bad_input) before anything is written; Error (blow_up), or
// Error (failure) when a condition has not come in time or a disk is full, with all that was computed kept.
RunResult run_plan(const scenario::Plan& plan, const RunOptions& options);

}  // namespace scree::run
