#include "job.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/campaign/tasks.hpp>
#include <scree/counted.hpp>
#include <scree/files/text_file.hpp>
#include <scree/run/result_kind.hpp>

namespace scree::campaign {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

Error changed(const Campaign& campaign, const std::string& what) {
  return Error(campaign.source.string(), fmt::format("{} changed since it was submitted", what),
               "repeat the command");
}

// The points of a task among those of a campaign; empty if the first is not one of them.
std::vector<std::size_t> places_of(const Task& task, const Campaign& campaign, const PluginHost& host) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < task.runs.size(); ++k) {
    const auto found = std::find_if(campaign.points.begin(), campaign.points.end(),
                                    [&](const Point& point) { return point.name == task.runs[k]; });
    if (found == campaign.points.end() && places.empty()) return {};
    if (found == campaign.points.end()) throw changed(campaign, task.runs[k]);
    if (inputs_key(campaign, *found, host) != task.inputs[k]) throw changed(campaign, task.runs[k]);
    places.push_back(std::size_t(found - campaign.points.begin()));
  }
  return places;
}

// The campaign of some of the points alone, and of the preparation of the first.
Campaign part_of(const Campaign& whole, const std::vector<std::size_t>& places) {
  Campaign part = whole;
  part.points.clear();
  for (const std::size_t place : places) part.points.push_back(whole.points[place]);
  if (!whole.preparation) return part;
  part.preparation =
      std::make_shared<const Campaign>(part_of(*whole.preparation, {whole.preparation_of[places.front()]}));
  part.preparation_of.assign(places.size(), 0);
  return part;
}

class Worker {
 public:
  Worker(CampaignDirectory& directory, const ExecutionOptions& options, const TaskOptions& task,
         PluginHost& host)
      : directory_(directory), options_(options), task_(task), host_(host) {
    options_.tables = false;
  }

  // Runs all points; their preparation has been made.
  Execution run(const Campaign& campaign) {
    std::vector<std::uint64_t> before;
    for (const Point& point : campaign.points) {
      await(point);
      before.push_back(steps_of(campaign, point));
    }
    const Execution result = executed(campaign);
    for (std::size_t k = 0; k < campaign.points.size(); ++k)
      check_progress(campaign, campaign.points[k], result.outcomes[k], before[k]);
    return result;
  }

  // Makes the only point of the preparation, unless it is there, or has failed: that would repeat itself.
  Outcome prepare(const Campaign& preparation) {
    const Point& point = preparation.points.front();
    const auto held = turn(point);
    Outcome outcome = directory_.outcome(preparation, point, host_);
    if (outcome.status == Status::finished || outcome.status == Status::failed || stopped()) return outcome;
    return run(preparation).outcomes.front();
  }

 private:
  bool stopped() const { return options_.stop && *options_.stop; }
  static void pause() { std::this_thread::sleep_for(std::chrono::milliseconds(200)); }

  // Tasks take turns at a preparation that several of them need.
  std::optional<files::DirectoryLock> turn(const Point& preparation) const {
    const fs::path place =
        directory_.files().path() / CampaignDirectory::tasks_folder / fs::path(preparation.name).filename();
    for (;; pause()) {
      auto lock = files::DirectoryLock::take(place, files::DirectoryLock::Children::inherit);
      if (lock || stopped()) return lock;
    }
  }

  // A process on a node that was lost, or that is just being ended, may still write the run.
  void await(const Point& point) const {
    const auto start = Clock::now();
    for (; directory_.is_written(point) && !stopped(); pause())
      if (std::chrono::duration<double>(Clock::now() - start).count() > task_.patience)
        throw Error(directory_.run(point).string(), "another process is writing there",
                    "wait for it, or end it, and repeat the command", ExitStatus::failure);
  }

  // An error before the runs begin is put into their logs, for --gather.
  Execution executed(const Campaign& campaign) {
    try {
      return execute(campaign, directory_, options_, host_);
    } catch (const Error& error) {
      for (const Point& point : campaign.points) {
        std::error_code failed;
        fs::create_directories(directory_.run(point), failed);
        if (!fs::exists(directory_.run(point) / campaign.record(), failed))
          files::write_atomically(directory_.log(point), fmt::format("scree: {}\n", error.what()));
      }
      throw;
    }
  }

  // Steps that a run had done when it was stopped; 0 of spectra.
  std::uint64_t steps_of(const Campaign& campaign, const Point& point) const {
    try {
      const fs::path record = directory_.run(point) / campaign.record();
      const auto json = run::parse_record(files::read_text(record));
      return json.is_object() ? json.value("steps", std::uint64_t(0)) : 0;
    } catch (const std::exception&) {
      return 0;  // there is none yet
    }
  }

  // A task whose share of time is too short for a step would be queued again for ever.
  void check_progress(const Campaign& campaign, const Point& point, const Outcome& after,
                      std::uint64_t before) const {
    constexpr unsigned most_restarts = 3;
    if (after.status != Status::interrupted || task_.restarts < most_restarts) return;
    if (!campaign.methods.empty() || steps_of(campaign, point) > before) return;
    throw Error(directory_.run(point).string(),
                fmt::format("was stopped before its first further step, after {}",
                            counted(task_.restarts, "restart")),
                "its limit of time is shorter than its start; give a longer --time, and repeat the command",
                ExitStatus::failure);
  }

  CampaignDirectory& directory_;
  ExecutionOptions options_;
  const TaskOptions& task_;
  PluginHost& host_;
};

}  // namespace

Execution run_task(const Campaign& campaign, CampaignDirectory& directory, std::size_t number,
                   const ExecutionOptions& options, const TaskOptions& task, PluginHost& host) {
  const TaskList list(directory);
  if (number >= list.size())
    throw Error(directory.files().path().string(),
                list.size() == 0 ? "has no tasks yet"
                                 : fmt::format("has tasks 0 to {}, and no task {}", list.size() - 1, number),
                "print them with --print-tasks, or submit them with --on slurm");
  Worker worker(directory, options, task, host);
  const bool prepares =
      list[number].runs.front().starts_with(std::string(CampaignDirectory::preparation_folder) + "/");
  if (prepares && !campaign.preparation) throw changed(campaign, "the preparation");
  const Campaign& of = prepares ? *campaign.preparation : campaign;
  const std::vector<std::size_t> places = places_of(list[number], of, host);
  if (places.empty()) throw changed(campaign, list[number].runs.front());
  const Campaign part = part_of(of, places);
  if (prepares) return worker.run(part);
  if (!part.preparation) return worker.run(part);
  const Outcome prepared = worker.prepare(*part.preparation);
  if (prepared.status == Status::finished) return worker.run(part);
  Execution result;
  result.interrupted = options.stop && *options.stop;
  result.preparations = {prepared};
  result.blew_up = prepared.blew_up;
  result.outcomes.resize(part.points.size());
  for (Outcome& outcome : result.outcomes) {
    if (result.interrupted) continue;
    outcome.status = Status::failed;
    outcome.problem = failed_with(part.preparation->points.front(), prepared);
  }
  return result;
}

}  // namespace scree::campaign
