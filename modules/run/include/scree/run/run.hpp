#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <scree/scenario/plan.hpp>
#include <scree/simulation.hpp>

namespace scree::run {

// Progress of a run, for progress bars.
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
  std::function<void(const Progress&)> on_progress;    // called about five times per second
  std::function<void(const std::string&)> on_message;  // one line for the user
  const std::atomic<bool>* stop = nullptr;             // set by Ctrl-C: the run saves its results and ends
};

// Result of an expectation.
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

// Runs a plan and writes its directory. Throws Error (bad_input) before anything is written; Error (blow_up),
// or Error (failure) if an end condition is not reached in time or the disk is full; results so far are kept.
RunResult run_plan(const scenario::Plan& plan, const RunOptions& options);

}  // namespace scree::run
