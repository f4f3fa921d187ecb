#include "work_list.hpp"

#include <algorithm>

namespace scree::campaign {

namespace {

namespace fs = std::filesystem;

// Checks the directory as the run itself will: it may contain other files.
void check_directory(const fs::path& path, const Campaign& campaign) {
  std::error_code failed;
  for (const fs::path& one : {path, path.parent_path()})
    if (fs::is_symlink(fs::symlink_status(one, failed)))
      throw Error(one.string(), "is a symbolic link, which is not followed",
                  "remove it, or give another --out");
  using run::RunDirectory;
  RunDirectory(path, RunDirectory::Existing::replace,
               campaign.methods.empty() ? RunDirectory::Kind::run : RunDirectory::Kind::spectrum);
}

}  // namespace

WorkList::WorkList(const Campaign& campaign, const CampaignDirectory& directory,
                   const ExecutionOptions& options, PluginHost& host, Execution& result)
    : campaign_(campaign), directory_(directory), options_(options), host_(host) {
  result.preparations = directory.preparations(campaign, host);
  result.outcomes = directory.outcomes(campaign, host);
  for (std::size_t k = 0; k < result.preparations.size(); ++k)
    add({*campaign.preparation, campaign.preparation->points[k], result.preparations[k]});
  for (std::size_t k = 0; k < result.outcomes.size(); ++k)
    add({campaign, campaign.points[k], result.outcomes[k],
         campaign.preparation ? &jobs_[campaign.preparation_of[k]] : nullptr});
  to_do_ = waiting_.size();
  result.finished_before = std::size_t(std::count_if(
      jobs_.begin(), jobs_.end(), [&](const Job& job) { return !job.to_do && !prepares(job); }));
}

void WorkList::add(Job job) {
  const bool branches_anew = job.preparation && job.preparation->to_do;
  job.to_do = options_.again || job.outcome.status != Status::finished || branches_anew;
  job.goes_on = !options_.again && !branches_anew && job.outcome.status == Status::interrupted &&
                directory_.has_state(job.point);
  job.id = jobs_.size();
  jobs_.push_back(job);
  if (job.to_do) waiting_.push_back(&jobs_.back());
}

void WorkList::check() {
  std::size_t checked = 0;
  for (const Job* job : waiting_) {
    if (stopped()) return;
    if (options_.on_check) options_.on_check(checked++, to_do_);
    if (prepares(*job))
      bodies_ = check_preparation(job->campaign, job->point, host_, options_.studies);
    else if (job->preparation && !job->preparation->is_there())
      check_keys(job->campaign, job->point, bodies_, host_, options_.studies);
    check_directory(directory_.run(job->point), job->campaign);
  }
  bodies_.clear();
  check_points();
  if (!waiting_.empty()) return;
  // `collect` may have changed even if all runs have finished. In a queue, preparations may be still to come.
  const auto ready = std::find_if(jobs_.begin(), jobs_.end(),
                                  [&](const Job& job) { return !prepares(job) && is_ready(job); });
  if (ready != jobs_.end()) check_point(ready->campaign, ready->point, host_, options_.studies);
}

void WorkList::check_points() {
  if (points_checked_) return;
  std::size_t checked = 0;
  for (const Job* job : waiting_) {
    if (stopped()) return;
    if (prepares(*job) || (job->preparation && !job->preparation->is_there())) continue;
    if (options_.on_check) options_.on_check(checked++, to_do_);
    check_point(job->campaign, job->point, host_, options_.studies);
  }
  points_checked_ = !campaign_.preparation || std::any_of(jobs_.begin(), jobs_.end(), [&](const Job& job) {
    return prepares(job) && job.is_there();
  });
}

bool WorkList::is_ready(const Job& job) const {
  return prepares(job) || (points_checked_ && (!job.preparation || job.preparation->is_there()));
}

}  // namespace scree::campaign
