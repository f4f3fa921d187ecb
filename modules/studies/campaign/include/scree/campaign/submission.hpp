#pragma once

#include <map>
#include <string>
#include <vector>

#include <scree/campaign/execution.hpp>

namespace scree::campaign {

struct SubmissionOptions {
  SlurmTable site;                   // of the campaign file and the command line
  std::size_t per_task = 1;          // runs of an element of an array
  unsigned processes = 1;            // of an element
  unsigned processors = 1;           // of each
  std::vector<std::string> command;  // of this campaign, to which --task K or --gather is added
};

// What a call has submitted.
struct Submission {
  std::size_t runs = 0, tasks = 0;  // preparations and points
  std::size_t before = 0;           // that wait or run in jobs of earlier calls
  std::size_t finished = 0;         // points
  std::vector<std::string> jobs;    // arrays
  std::string gather;               // job that gathers the tables; empty if there was nothing to submit
  std::string name;                 // of all jobs of this directory
};

// Gives what is neither finished nor in the queue to Slurm: an array for the preparations, arrays for the
// points, which wait for theirs, and a job that gathers. The directory has been taken. Throws Error
// (bad_input) if a point is refused, and if Slurm refuses, then with what was submitted before.
Submission submit(const Campaign& campaign, CampaignDirectory& directory, const SubmissionOptions& submission,
                  const ExecutionOptions& options, PluginHost& host);

// What Slurm knows of the runs of a directory; empty if nothing was submitted from it.
struct RunsInQueue {
  std::string name;      // of the jobs
  std::size_t jobs = 0;  // that wait or run, also that which gathers
  // By the name of the run: a job that waits or runs, "12_3", with the reason why it waits, and any job.
  std::map<std::string, std::string> waiting, running, last;
};
RunsInQueue runs_in_queue(const CampaignDirectory& directory);

// Marks the runs of points or preparations that wait in jobs as queued. Returns, by name, which job has or
// had each run and whether its state is saved: "job 12_3, Priority, saved".
std::map<std::string, std::string> mark_queued(const RunsInQueue& queue, const Campaign& campaign,
                                               const CampaignDirectory& directory,
                                               std::vector<Outcome>& outcomes);

}  // namespace scree::campaign
