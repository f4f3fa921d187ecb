#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <scree/campaign/campaign_directory.hpp>

namespace scree::campaign {

// Progress of a campaign.
struct Tally {
  std::size_t total = 0, finished = 0, running = 0, failed = 0;
  double share = 0;      // 0 to 1, of the work of this call
  double wall_time = 0;  // (s) since the start
};

struct ExecutionOptions {
  unsigned jobs = 1;     // concurrent runs
  unsigned threads = 1;  // of each run, or of each of its ranks
  unsigned ranks =
      0;  // processes of each run, which mpirun starts, or srun in a job of Slurm; 0: one without
  bool again = false;  // all runs begin anew, also finished ones
  bool tables = true;  // those in the directory, and its page, are written
  std::vector<std::string> plugin_directories;
  scenario::StudyTables studies;                           // whose tables the scenario may have
  std::filesystem::path program = "/proc/self/exe";        // called as `scree run` and `scree resume`
  const std::atomic<bool>* stop = nullptr;                 // set by Ctrl-C: runs save their results and end
  std::function<void(const Tally&)> on_progress;           // called a few times per second
  std::function<void(std::size_t, std::size_t)> on_check;  // points checked so far, and in total
  std::function<void(const std::string&)> on_warning;      // one line "<what>; <cure>"
};

// Result of a campaign; outcomes in the order of its points.
struct Execution {
  std::vector<Outcome> outcomes;
  std::size_t finished_before = 0;  // not run again
  bool interrupted = false;
  std::vector<Outcome> preparations = {};    // in the order of Campaign::preparation->points
  std::vector<std::size_t> prepared = {};    // numbers of preparations that this call has finished
  std::size_t gone_on = 0;                   // runs and preparations that went on from a state
  std::vector<std::string> begun_anew = {};  // "<name>: <why it could not go on>"
  bool blew_up = false;                      // a run or preparation of this call

  std::size_t count(Status status) const;
};

// Throws the errors that execute() throws before anything is written.
void check(const Campaign& campaign, CampaignDirectory& directory, const ExecutionOptions& options,
           PluginHost& host);

// Runs all unfinished points, each in its own process, and updates the tables in the directory. Interrupted
// runs go on from their last state. The campaign comes from branched(): its preparations are run first.
// Throws Error (bad_input) if a point is refused: before anything is written, or, for points that can only be
// checked with the state of a preparation, before any point is run. Throws Error (failure) if the directory
// cannot be written, after all runs have ended.
Execution execute(const Campaign& campaign, CampaignDirectory& directory, const ExecutionOptions& options,
                  PluginHost& host);

}  // namespace scree::campaign
