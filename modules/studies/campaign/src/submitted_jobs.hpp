#pragma once

#include "slurm.hpp"

#include <map>

#include <scree/campaign/tasks.hpp>

namespace scree::campaign {

// tasks/jobs.json in the directory of a campaign: what was submitted, written before and after each sbatch.
class SubmittedJobs {
 public:
  struct Entry {
    std::string job;  // empty: about to be submitted
    std::size_t first = 0;
    std::string elements;  // ranges
  };

  // Of a directory; the name of its jobs is that of its path when it was first submitted. Throws Error if it
  // cannot be read.
  explicit SubmittedJobs(const CampaignDirectory& directory);

  const std::string& name() const { return name_; }
  bool empty() const { return entries_.empty(); }
  // Gives entries without a job that of the queue, if there is one: whoever submitted it ended before it was
  // written down. Others are removed.
  // Returns whether there were any.
  bool adopt(const std::vector<QueuedJob>& queue);
  void write() const;
  // Submits an array of tasks with these words, between two records.
  std::string submit(const Array& array, const std::vector<std::string>& words);
  // Throws Error if a job that was submitted failed without a trace in the directory.
  void check_seen(const std::vector<QueuedJob>& queue) const;

  // Tasks in the queue, and the job that had each task last.
  static std::map<std::size_t, QueuedJob> queued_tasks(const std::vector<QueuedJob>& queue);
  std::map<std::size_t, std::string> job_of_tasks() const;
  // sbatch --comment of an array, from which the queue alone tells its tasks.
  static std::string comment_of(std::size_t first);

 private:
  const CampaignDirectory& directory_;
  std::string name_;
  std::vector<Entry> entries_;
};

}  // namespace scree::campaign
