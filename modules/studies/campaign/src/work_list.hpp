#pragma once

#include "job.hpp"

#include <deque>

namespace scree::campaign {

// What is to be done of a campaign: its preparations and points that have not finished, in their order.
class WorkList {
 public:
  // Fills the outcomes of `result`, whose elements the jobs refer to, and finished_before. All arguments
  // outlive this object.
  WorkList(const Campaign& campaign, const CampaignDirectory& directory, const ExecutionOptions& options,
           PluginHost& host, Execution& result);
  WorkList(const WorkList&) = delete;
  WorkList& operator=(const WorkList&) = delete;

  // Throws Error (bad_input) if a job that is to be done is refused, as far as that is known before its
  // preparation has been run.
  void check();
  // Checks, once, all points whose preparation is finished: the others differ from them only in the seed.
  void check_points();
  // Whether a job can begin.
  bool is_ready(const Job& job) const;
  bool prepares(const Job& job) const { return &job.campaign == campaign_.preparation.get(); }
  bool stopped() const { return options_.stop && *options_.stop; }

  std::deque<Job>& jobs() { return jobs_; }         // the preparations, then the points; the id is the place
  std::deque<Job*>& waiting() { return waiting_; }  // that are to be done
  std::size_t size() const { return to_do_; }       // of those that are to be done, also after they ended

 private:
  void add(Job job);

  const Campaign& campaign_;
  const CampaignDirectory& directory_;
  const ExecutionOptions& options_;
  PluginHost& host_;
  std::deque<Job> jobs_;
  std::deque<Job*> waiting_;
  std::size_t to_do_ = 0;
  std::vector<Body> bodies_;  // of a preparation that is to be run
  bool points_checked_ = false;
};

}  // namespace scree::campaign
