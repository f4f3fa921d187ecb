#pragma once

#include <scree/campaign/execution.hpp>

namespace scree::campaign {

// A run of this call of scree campaign: a preparation or a point.
struct Job {
  const Campaign& campaign;  // to which the point belongs
  const Point& point;
  Outcome& outcome;
  const Job* preparation = nullptr;  // from which it branches
  std::size_t id = 0;                // in the pool of processes
  bool to_do = false;                // waits or runs
  bool goes_on = false;              // from a state of its former run

  bool has_failed() const { return !to_do && outcome.status == Status::failed; }
  // Whether other runs can branch from it.
  bool is_there() const { return !to_do && outcome.status == Status::finished; }
};

// The command line of a job.
std::vector<std::string> command_of(const Job& job, const std::filesystem::path& directory,
                                    const ExecutionOptions& options);

// The last line "scree: ..." of a log that is no warning, without that prefix; empty if there is none.
std::string reported_in(const std::filesystem::path& log);
// Reason why a run has not finished: the last line "scree: ..." of its log without that prefix, else its last
// line; then `how` its process ended, in brackets.
std::string problem_of(const std::filesystem::path& log, const std::string& how);
// Reason why the points of a preparation have failed.
std::string failed_with(const Point& preparation, const Outcome& outcome);
// Progress of a run, 0 to 1, from the last progress line of its log, " 42 %  ..."; 0 if there is none.
double share_in(const std::filesystem::path& log);

}  // namespace scree::campaign
