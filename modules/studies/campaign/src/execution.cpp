#include "job.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <deque>

#include <fmt/format.h>

#include <scree/campaign/execution.hpp>
#include <scree/campaign/process_pool.hpp>
#include <scree/campaign/report.hpp>

namespace scree::campaign {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

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

class Executor {
 public:
  Executor(const Campaign& campaign, CampaignDirectory& directory, const ExecutionOptions& options,
           PluginHost& host)
      : campaign_(campaign), directory_(directory), options_(options), host_(host) {
    result_.preparations = directory.preparations(campaign, host);
    result_.outcomes = directory.outcomes(campaign, host);
    for (std::size_t k = 0; k < result_.preparations.size(); ++k)
      add({*campaign.preparation, campaign.preparation->points[k], result_.preparations[k]});
    for (std::size_t k = 0; k < result_.outcomes.size(); ++k)
      add({campaign, campaign.points[k], result_.outcomes[k],
           campaign.preparation ? &jobs_[campaign.preparation_of[k]] : nullptr});
    to_do_ = waiting_.size();
    result_.finished_before = std::size_t(std::count_if(
        jobs_.begin(), jobs_.end(), [&](const Job& job) { return !job.to_do && !prepares(job); }));
  }

  void check() {
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
    // `collect` may have changed even if all runs have finished.
    if (waiting_.empty()) check_point(campaign_, campaign_.points.front(), host_, options_.studies);
  }

  Execution run() {
    if (stopped()) return end();  // before anything is written
    write_report(campaign_, result_, directory_);
    while (!(stopped() || waiting_.empty()) || pool_.size() > 0) {
      fill();
      constexpr double poll_interval = 0.2;  // (s)
      for (const ProcessPool::Ended& ended : pool_.wait(poll_interval)) take(ended);
      save_periodically();
      if (stopped()) interrupt();
      report();
    }
    write_report(campaign_, result_, directory_);
    add_page();
    return end();
  }

 private:
  // The tables are complete without it.
  void add_page() const {
    try {
      write_page(directory_);
    } catch (const Error& error) {
      if (options_.on_warning)
        options_.on_warning(fmt::format("the report of the campaign is missing: {}", error.what()));
    }
  }

  bool stopped() const { return options_.stop && *options_.stop; }
  bool prepares(const Job& job) const { return &job.campaign == campaign_.preparation.get(); }

  void add(Job job) {
    const bool branches_anew = job.preparation && job.preparation->to_do;
    job.to_do = options_.again || job.outcome.status != Status::finished || branches_anew;
    job.goes_on = !options_.again && !branches_anew && job.outcome.status == Status::interrupted &&
                  directory_.has_state(job.point);
    job.id = jobs_.size();
    jobs_.push_back(job);
    if (job.to_do) waiting_.push_back(&jobs_.back());
  }

  // Checks, once, all points whose preparation is finished: the others differ from them only in the seed.
  void check_points() {
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

  Execution end() {
    result_.interrupted = stopped() && (done_ < to_do_ || result_.count(Status::interrupted) > 0);
    return result_;
  }

  bool is_ready(const Job& job) const {
    return prepares(job) || (points_checked_ && (!job.preparation || job.preparation->is_there()));
  }

  void fill() {
    while (!stopped() && pool_.size() < options_.jobs) {
      const auto next =
          std::find_if(waiting_.begin(), waiting_.end(), [&](const Job* job) { return is_ready(*job); });
      if (next == waiting_.end()) return;
      Job& job = **next;
      waiting_.erase(next);
      start(job);
    }
  }

  void start(Job& job) {
    const fs::path path = directory_.run(job.point);
    std::error_code failed;  // a failure is reported when the log is opened
    fs::create_directories(path, failed);
    using Log = ProcessPool::Log;
    pool_.start(job.id, command_of(job, path, options_), directory_.log(job.point),
                job.goes_on ? Log::append : Log::replace);
    job.outcome = {};
    job.outcome.status = Status::running;
    running_.push_back(&job);
  }

  void take(const ProcessPool::Ended& ended) {
    Job& job = jobs_[ended.id];
    std::erase(running_, &job);
    if (job.goes_on && ended.status == int(ExitStatus::bad_input)) return begin_anew(job);
    result_.gone_on += job.goes_on;
    result_.blew_up |= ended.status == int(ExitStatus::blow_up);
    job.outcome = outcome_of(job, ended.how);
    finish(job);
    if (prepares(job)) follow(job);
    table_is_old_ = true;
  }

  void finish(Job& job) {
    job.to_do = false;
    ++done_;
    failed_ += job.outcome.status == Status::failed;
  }

  // Runs a job from its start, since its state cannot be read or belongs to other plug-ins.
  void begin_anew(Job& job) {
    result_.begun_anew.push_back(job.point.name + ": " + problem_of(directory_.log(job.point), ""));
    job.goes_on = false;
    job.outcome.status = Status::interrupted;
    waiting_.push_front(&job);
  }

  Outcome outcome_of(const Job& job, const std::string& how) const {
    Outcome outcome = directory_.outcome(job.campaign, job.point, host_);
    if (outcome.status == Status::changed && how.empty())
      outcome.problem = "the scenario changed during the campaign; run the campaign again";
    else if (outcome.problem.empty() && outcome.status != Status::finished)
      outcome.problem = problem_of(directory_.log(job.point), how);
    // A run that was interrupted has not failed.
    if (outcome.status != Status::finished && outcome.status != Status::failed)
      outcome.status = interrupted_ ? Status::interrupted : Status::failed;
    if (outcome.status != Status::failed) outcome.problem.clear();
    return outcome;
  }

  // After the end of a preparation: its points can run, or have failed with it.
  void follow(const Job& preparation) {
    if (preparation.is_there()) {
      result_.prepared.push_back(preparation.id);
      check_points();
    }
    if (!preparation.has_failed()) return;
    std::erase_if(waiting_, [&](Job* job) {
      if (job->preparation != &preparation) return false;
      job->outcome = {};
      job->outcome.status = Status::failed;
      job->outcome.problem =
          fmt::format("{} failed: {}", preparation.point.name, preparation.outcome.problem);
      finish(*job);
      return true;
    });
  }

  void interrupt() {
    if (!interrupted_) pool_.signal(SIGINT);
    interrupted_ = true;
  }

  double wall_time() const { return std::chrono::duration<double>(Clock::now() - started_).count(); }

  void report() const {
    if (!options_.on_progress) return;
    double done = double(done_);
    for (const Job* job : running_) done += share_in(directory_.log(job->point));
    const double share = to_do_ ? done / double(to_do_) : 1;
    options_.on_progress({result_.outcomes.size(), result_.count(Status::finished), pool_.size(), failed_,
                          share, wall_time()});
  }

  // Keeps the tables up to date during the campaign, also in case the computer fails.
  void save_periodically() {
    constexpr double seconds_between_tables = 10;
    if (!table_is_old_ || wall_time() - last_table_ < seconds_between_tables) return;
    last_table_ = wall_time();
    table_is_old_ = false;
    write_report(campaign_, result_, directory_);
  }

  const Campaign& campaign_;
  CampaignDirectory& directory_;
  const ExecutionOptions& options_;
  PluginHost& host_;
  Execution result_;
  std::deque<Job> jobs_;  // the preparations, then the points; the id is the place
  std::deque<Job*> waiting_;
  std::vector<Body> bodies_;  // of a preparation that is to be run
  std::vector<Job*> running_;
  std::size_t to_do_ = 0, done_ = 0, failed_ = 0;  // of this call
  ProcessPool pool_;
  bool points_checked_ = false;
  bool interrupted_ = false;  // the runs have received SIGINT
  Clock::time_point started_ = Clock::now();
  double last_table_ = 0;      // (s) of wall time
  bool table_is_old_ = false;  // runs ended since it was written
};

}  // namespace

std::size_t Execution::count(Status status) const {
  return std::size_t(std::count_if(outcomes.begin(), outcomes.end(),
                                   [&](const Outcome& outcome) { return outcome.status == status; }));
}

void check(const Campaign& campaign, CampaignDirectory& directory, const ExecutionOptions& options,
           PluginHost& host) {
  Executor(campaign, directory, options, host).check();
}

Execution execute(const Campaign& campaign, CampaignDirectory& directory, const ExecutionOptions& options,
                  PluginHost& host) {
  Executor executor(campaign, directory, options, host);
  executor.check();
  return executor.run();
}

}  // namespace scree::campaign
