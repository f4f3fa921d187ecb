#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <scree/campaign/campaign_directory.hpp>

namespace scree::campaign {

// How far a campaign has come.
struct Tally {
  std::size_t total = 0, finished = 0, running = 0, failed = 0;
  double share = 0;  // 0 to 1, of the work that this call has to do
  double wall = 0;   // (s) since the start
};

struct ExecutionOptions {
  unsigned jobs = 1;     // runs side by side
  unsigned threads = 1;  // of each run
  bool again = false;    // also what has finished
  std::vector<std::string> plugin_directories;
  std::filesystem::path program = "/proc/self/exe";        // that is called as `scree run`; this one
  const std::atomic<bool>* stop = nullptr;                 // set by Ctrl-C: runs save what they have and end
  std::function<void(const Tally&)> on_progress;           // called a few times a second
  std::function<void(std::size_t, std::size_t)> on_check;  // points checked so far, of how many
};

// What a campaign came to, outcomes in the order of its points.
struct Execution {
  std::vector<Outcome> outcomes;
  std::size_t finished_before = 0;  // and not run again
  bool interrupted = false;

  std::size_t count(State state) const;
};

// Runs what has not finished, each in a process of its own, and keeps the tables of the directory up to date.
// Throws Error (bad_input) before anything is written if any point is refused; Error (failure) if the
// directory cannot be written, with all runs ended.
Execution execute(const Campaign& campaign, CampaignDirectory& directory, const ExecutionOptions& options,
                  PluginHost& host);

}  // namespace scree::campaign
