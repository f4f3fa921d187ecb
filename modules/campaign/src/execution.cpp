#include "run_log.hpp"

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

// The same check as by the run itself: the directory may contain other files.
void check_directory(const fs::path& path) {
  std::error_code failed;
  if (fs::is_symlink(fs::symlink_status(path, failed)))
    throw Error(fmt::format("{}: is a symbolic link, which is not followed; remove it, or give another --out",
                            path.string()));
  run::RunDirectory(path, run::RunDirectory::Existing::replace);
}

class Executor {
 public:
  Executor(const Campaign& campaign, CampaignDirectory& directory, const ExecutionOptions& options)
      : campaign_(campaign), directory_(directory), options_(options) {
    result_.outcomes = directory.outcomes(campaign);
    for (std::size_t k = 0; k < result_.outcomes.size(); ++k)
      if (options.again || result_.outcomes[k].status != Status::finished) waiting_.push_back(k);
    to_do_ = waiting_.size();
    result_.finished_before = result_.outcomes.size() - to_do_;
  }

  void check(PluginHost& host) const {
    // `collect` may have changed even if all runs have finished.
    if (waiting_.empty()) check_point(campaign_, campaign_.points.front(), host);
    std::size_t checked = 0;
    for (const std::size_t k : waiting_) {
      if (stopped()) return;
      if (options_.on_check) options_.on_check(checked++, to_do_);
      check_point(campaign_, campaign_.points[k], host);
      check_directory(directory_.run(campaign_.points[k]));
    }
  }

  Execution run() {
    if (stopped()) return end();  // before anything is written
    write_report(campaign_, result_.outcomes, directory_);
    while (!(stopped() || waiting_.empty()) || pool_.size() > 0) {
      fill();
      constexpr double poll_interval = 0.2;  // (s)
      for (const ProcessPool::Ended& ended : pool_.wait(poll_interval)) take(ended);
      if (stopped()) interrupt();
      report();
    }
    write_report(campaign_, result_.outcomes, directory_);
    return end();
  }

 private:
  bool stopped() const { return options_.stop && *options_.stop; }

  Execution end() {
    result_.interrupted = stopped() && (done_ < to_do_ || result_.count(Status::interrupted) > 0);
    return result_;
  }

  void fill() {
    while (!stopped() && !waiting_.empty() && pool_.size() < options_.jobs) {
      const std::size_t k = waiting_.front();
      waiting_.pop_front();
      const Point& point = campaign_.points[k];
      std::error_code failed;  // a failure is reported when the log is opened
      fs::create_directories(directory_.run(point), failed);
      pool_.start(k, command(point), directory_.log(point));
      result_.outcomes[k] = {};
      result_.outcomes[k].status = Status::running;
      running_.push_back(k);
    }
  }

  std::vector<std::string> command(const Point& point) const {
    // A name that begins with "-" must not be taken for an option.
    const bool like_option = campaign_.scenario.string().starts_with('-');
    std::vector<std::string> words = {options_.program.string(),
                                      "run",
                                      (like_option ? "." / campaign_.scenario : campaign_.scenario).string(),
                                      "--out",
                                      directory_.run(point).string(),
                                      "--overwrite",
                                      "--threads",
                                      std::to_string(options_.threads)};
    for (const std::string& override_text : point.overrides())
      words.insert(words.end(), {"--set", override_text});
    for (const std::string& plugins : options_.plugin_directories)
      words.insert(words.end(), {"--plugins", plugins});
    return words;
  }

  void take(const ProcessPool::Ended& ended) {
    const Point& point = campaign_.points[ended.id];
    std::erase(running_, ended.id);
    ++done_;
    Outcome outcome = directory_.outcome(campaign_, point);
    if (outcome.status == Status::changed && ended.how.empty())
      outcome.problem = "the scenario changed during the campaign; run the campaign again";
    else if (outcome.problem.empty() && outcome.status != Status::finished)
      outcome.problem = problem_of(directory_.log(point), ended.how);
    // A run that was interrupted has not failed.
    if (outcome.status != Status::finished && outcome.status != Status::failed)
      outcome.status = interrupted_ ? Status::interrupted : Status::failed;
    if (outcome.status != Status::failed) outcome.problem.clear();
    failed_ += outcome.status == Status::failed;
    result_.outcomes[ended.id] = std::move(outcome);
    save_periodically();
  }

  void interrupt() {
    if (!interrupted_) pool_.signal(SIGINT);
    interrupted_ = true;
  }

  double wall() const { return std::chrono::duration<double>(Clock::now() - started_).count(); }

  void report() const {
    if (!options_.on_progress) return;
    double done = double(done_);
    for (const std::size_t k : running_) done += share_in(directory_.log(campaign_.points[k]));
    const double share = to_do_ ? done / double(to_do_) : 1;
    options_.on_progress(
        {result_.outcomes.size(), result_.count(Status::finished), pool_.size(), failed_, share, wall()});
  }

  // Keeps the tables up to date during the campaign, also in case the computer fails.
  void save_periodically() {
    constexpr double seconds_between_tables = 10;
    if (wall() - last_table_ < seconds_between_tables) return;
    last_table_ = wall();
    write_report(campaign_, result_.outcomes, directory_);
  }

  const Campaign& campaign_;
  CampaignDirectory& directory_;
  const ExecutionOptions& options_;
  Execution result_;
  std::deque<std::size_t> waiting_;                // points
  std::vector<std::size_t> running_;               // points
  std::size_t to_do_ = 0, done_ = 0, failed_ = 0;  // of this call
  ProcessPool pool_;
  bool interrupted_ = false;  // the runs have received SIGINT
  Clock::time_point started_ = Clock::now();
  double last_table_ = 0;  // (s) of wall time
};

}  // namespace

std::size_t Execution::count(Status status) const {
  return std::size_t(std::count_if(outcomes.begin(), outcomes.end(),
                                   [&](const Outcome& outcome) { return outcome.status == status; }));
}

Execution execute(const Campaign& campaign, CampaignDirectory& directory, const ExecutionOptions& options,
                  PluginHost& host) {
  Executor executor(campaign, directory, options);
  executor.check(host);
  return executor.run();
}

}  // namespace scree::campaign
