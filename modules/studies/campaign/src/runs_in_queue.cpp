#include "submitted_jobs.hpp"

#include <fmt/format.h>

#include <scree/campaign/submission.hpp>

namespace scree::campaign {

RunsInQueue runs_in_queue(const CampaignDirectory& directory) {
  RunsInQueue runs;
  SubmittedJobs jobs(directory);
  if (jobs.empty()) return runs;
  const TaskList list(directory);
  const std::vector<QueuedJob> queue = slurm::queue(jobs.name());
  jobs.adopt(queue);
  runs.name = jobs.name();
  runs.jobs = queue.size();
  for (const auto& [task, job] : jobs.job_of_tasks())
    if (task < list.size())
      for (const std::string& run : list[task].runs) runs.last[run] = job;
  for (const auto& [task, job] : SubmittedJobs::queued_tasks(queue)) {
    if (task >= list.size()) continue;
    const bool waits = job.state == "PENDING";
    for (const std::string& run : list[task].runs)
      (waits ? runs.waiting : runs.running)[run] =
          waits ? fmt::format("{}, {}", job.id(), job.reason) : job.id();
  }
  return runs;
}

std::map<std::string, std::string> mark_queued(const RunsInQueue& queue, const Campaign& campaign,
                                               const CampaignDirectory& directory,
                                               std::vector<Outcome>& outcomes) {
  std::map<std::string, std::string> notes;
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    const Point& point = campaign.points[k];
    Outcome& outcome = outcomes[k];
    const bool saved = outcome.status == Status::interrupted && directory.has_state(point);
    std::string& note = notes[point.name];
    const auto named = [&](const std::map<std::string, std::string>& jobs) {
      const auto job = jobs.find(point.name);
      if (job != jobs.end()) note = "job " + job->second;
      return job != jobs.end();
    };
    const bool at_rest = outcome.status != Status::finished && outcome.status != Status::running;
    if (named(queue.waiting) || named(queue.running)) {
      if (at_rest) outcome.status = Status::queued;
    } else {
      named(queue.last);
    }
    if (saved) note += note.empty() ? "saved" : ", saved";
  }
  return notes;
}

}  // namespace scree::campaign
