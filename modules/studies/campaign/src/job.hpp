#pragma once

#include <scree/campaign/execution.hpp>

namespace scree::campaign {

// A run of this call: a preparation or a point of a campaign.
struct Job {
  const Campaign& campaign;  // that of the point
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

// The call of the program for a job.
std::vector<std::string> command_of(const Job& job, const std::filesystem::path& directory,
                                    const ExecutionOptions& options);

}  // namespace scree::campaign
