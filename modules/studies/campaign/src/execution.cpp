#include "work_list.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>

#include <fmt/format.h>

#include <scree/campaign/execution.hpp>
#include <scree/campaign/process_pool.hpp>
#include <scree/campaign/report.hpp>

namespace scree::campaign {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// The local pool of processes.
class Executor {
 public:
  Executor(const Campaign& campaign, CampaignDirectory& directory, const ExecutionOptions& options,
           PluginHost& host)
      : campaign_(campaign),
        directory_(directory),
        options_(options),
        host_(host),
        work_(campaign, directory, options, host, result_) {}

  void check() { work_.check(); }

  Execution run() {
    if (stopped()) return end();  // before anything is written
    write_tables();
    while (!(stopped() || waiting_.empty()) || pool_.size() > 0) {
      fill();
      constexpr double poll_interval = 0.2;  // (s)
      for (const ProcessPool::Ended& ended : pool_.wait(poll_interval)) take(ended);
      save_periodically();
      if (stopped()) interrupt();
      report();
    }
    write_tables();
    add_page();
    return end();
  }

 private:
  // The tables are complete without it.
  void add_page() const {
    if (!options_.tables) return;
    try {
      write_page(directory_);
    } catch (const Error& error) {
      if (options_.on_warning)
        options_.on_warning(fmt::format("the report of the campaign is missing: {}", error.what()));
    }
  }

  bool stopped() const { return work_.stopped(); }
  void write_tables() const {
    if (options_.tables) write_report(campaign_, result_, directory_);
  }

  Execution end() {
    result_.interrupted = stopped() && (done_ < work_.size() || result_.count(Status::interrupted) > 0);
    return result_;
  }

  void fill() {
    while (!stopped() && pool_.size() < options_.jobs) {
      const auto next = std::find_if(waiting_.begin(), waiting_.end(),
                                     [&](const Job* job) { return work_.is_ready(*job); });
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
    Job& job = work_.jobs()[ended.id];
    std::erase(running_, &job);
    if (job.goes_on && ended.status == int(ExitStatus::bad_input)) return begin_anew(job);
    result_.gone_on += job.goes_on;
    result_.blew_up |= ended.status == int(ExitStatus::blow_up);
    job.outcome = outcome_of(job, ended.how);
    finish(job);
    if (work_.prepares(job)) follow(job);
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
      work_.check_points();
    }
    if (!preparation.has_failed()) return;
    std::erase_if(waiting_, [&](Job* job) {
      if (job->preparation != &preparation) return false;
      job->outcome = {};
      job->outcome.status = Status::failed;
      job->outcome.problem = failed_with(preparation.point, preparation.outcome);
      finish(*job);
      return true;
    });
  }

  void interrupt() {
    // Unlike another SIGINT or SIGTERM, these do not end a run that a batch system has just signalled itself.
    // mpirun passes SIGUSR1 on and nothing else without killing the ranks a second later.
    if (!interrupted_) pool_.signal(options_.ranks > 0 ? SIGUSR1 : SIGHUP);
    interrupted_ = true;
  }

  double wall_time() const { return std::chrono::duration<double>(Clock::now() - started_).count(); }

  void report() const {
    if (!options_.on_progress) return;
    double done = double(done_);
    for (const Job* job : running_) done += share_in(directory_.log(job->point));
    const double share = work_.size() ? done / double(work_.size()) : 1;
    options_.on_progress({result_.outcomes.size(), result_.count(Status::finished), pool_.size(), failed_,
                          share, wall_time()});
  }

  // Keeps the tables up to date during the campaign, also in case the computer fails.
  void save_periodically() {
    constexpr double seconds_between_tables = 10;
    if (!table_is_old_ || wall_time() - last_table_ < seconds_between_tables) return;
    last_table_ = wall_time();
    table_is_old_ = false;
    write_tables();
  }

  const Campaign& campaign_;
  CampaignDirectory& directory_;
  const ExecutionOptions& options_;
  PluginHost& host_;
  Execution result_;
  WorkList work_;
  std::deque<Job*>& waiting_ = work_.waiting();
  std::vector<Job*> running_;
  std::size_t done_ = 0, failed_ = 0;  // of this call
  ProcessPool pool_;
  bool interrupted_ = false;  // the runs have received the signal
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
