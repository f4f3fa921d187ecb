#include "campaign_tasks.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/campaign/gather.hpp>
#include <scree/campaign/tasks.hpp>
#include <scree/counted.hpp>
#include <scree/files/directory_lock.hpp>
#include <scree/files/text.hpp>

namespace scree::tool {

namespace {

using campaign::CampaignDirectory;

void print(const std::string& text) { fmt::print("{}", files::escaped(text, files::Escapes::lines)); }

// The program and the options of this call that a task needs.
std::vector<std::string> command_of(const campaign::Campaign& c, const CampaignArguments& a) {
  const auto plain = [](const std::filesystem::path& path) {
    return (path.string().starts_with('-') ? "." / path : path).string();
  };
  std::vector<std::string> words = {std::filesystem::read_symlink("/proc/self/exe").string(), "campaign",
                                    plain(c.source), "--out", plain(directory_of(c, a))};
  for (const std::string& text : a.overrides) words.insert(words.end(), {"--set", text});
  for (const std::string& folder : a.plugins.directories) words.insert(words.end(), {"--plugins", folder});
  words.insert(words.end(), {"--threads", std::to_string(a.threads), "--jobs",
                             std::to_string(std::max(1u, a.jobs)), "--quiet"});
  if (a.ranks > 0) words.insert(words.end(), {"--ranks", std::to_string(a.ranks)});
  return words;
}

std::size_t number_of(const std::string& text) {
  std::size_t number = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failed != std::errc() || end != text.data() + text.size())
    throw Error(fmt::format("--task {}", files::one_line(text)), "is no number of a task",
                "give one of --print-tasks");
  return number;
}

// Tasks that end together gather together: a job waits for the campaign that has the directory.
void wait_for_directory(const std::filesystem::path& path) {
  constexpr int longest_wait = 180;  // (s)
  if (!std::getenv("SLURM_JOB_ID")) return;
  for (int k = 0; k < longest_wait && files::DirectoryLock::is_held(path); ++k)
    std::this_thread::sleep_for(std::chrono::seconds(1));
}

std::string submission_report(const campaign::Submission& s, const std::string& command) {
  std::string text;
  if (s.runs > 0)
    text += fmt::format("submitted {} in {} as {} {}; job {} gathers the tables\n", counted(s.runs, "run"),
                        counted(s.tasks, "task"), s.jobs.size() == 1 ? "job" : "jobs",
                        s.jobs.size() > 3 ? fmt::format("{} to {}", s.jobs.front(), s.jobs.back())
                                          : fmt::format("{}", fmt::join(s.jobs, ", ")),
                        s.gather);
  if (s.before > 0) text += fmt::format("{} in the queue already\n", counted(s.before, "run"));
  if (s.finished > 0) text += fmt::format("{} finished already\n", counted(s.finished, "run"));
  return text + fmt::format("follow them with {} --list; scancel --name {} cancels all\n", command, s.name);
}

}  // namespace

std::filesystem::path directory_of(const campaign::Campaign& c, const CampaignArguments& a) {
  constexpr auto kind = run::RunDirectory::Kind::campaign;
  const std::filesystem::path own = run::RunDirectory::default_for(c.source, kind);
  if (a.out.empty()) return own;
  return a.files.size() > 1 ? std::filesystem::path(a.out) / own.filename() : std::filesystem::path(a.out);
}

void check_batch_options(const CampaignArguments& a) {
  const int chosen = a.list + a.gather + a.print_tasks + !a.task.empty() + !a.on.empty();
  const auto refuse = [](const char* what, const char* cure) { throw Error("scree campaign", what, cure); };
  if (chosen > 1)
    refuse("--list, --print-tasks, --task, --gather and --on exclude each other", "give one of them");
  if (a.overwrite && chosen > 0)
    refuse("--overwrite begins runs of this call alone anew", "remove their directories instead");
  if (a.on.empty() && !(a.partition.empty() && a.time.empty()))
    refuse("--partition and --time are for a batch system", "add --on slurm");
  if (a.per_task > 1 && a.on.empty() && !a.print_tasks)
    refuse("--per-task is for tasks", "add --on slurm or --print-tasks");
  if (!a.task.empty() && a.files.size() > 1) refuse("--task is of one campaign", "give one file");
}

void refuse_queued(const CampaignDirectory& directory) {
  std::error_code failed;
  if (!std::filesystem::exists(directory.files().path() / CampaignDirectory::tasks_folder / "jobs.json",
                               failed))
    return;
  const campaign::RunsInQueue queue = campaign::runs_in_queue(directory);
  if (queue.jobs > 0)
    throw Error(
        directory.files().path().string(),
        fmt::format("{} in the queue of Slurm", queue.jobs == 1 ? "a job of it is" : "jobs of it are"),
        fmt::format("wait for them, add --on slurm, or cancel them: scancel --name {}", queue.name));
}

ExitStatus list_points(const campaign::Campaign& c, const CampaignArguments& a, const PluginHost& host) {
  const CampaignDirectory directory(directory_of(c, a), c, false);
  std::vector<campaign::Outcome> preparations = directory.preparations(c, host),
                                 outcomes = directory.outcomes(c, host);
  std::map<std::string, std::string> notes;
  try {
    const campaign::RunsInQueue queue = campaign::runs_in_queue(directory);
    if (!queue.name.empty()) {
      notes = campaign::mark_queued(queue, c, directory, outcomes);
      if (c.preparation) notes.merge(campaign::mark_queued(queue, *c.preparation, directory, preparations));
    }
  } catch (const Error& error) {
    report_warning(fmt::format("jobs are not listed: {}", error.what()));
  }
  print(campaign::list_report(c, preparations, outcomes, notes) +
        campaign::leftover_report(directory.leftovers(c)));
  return ExitStatus::success;
}

ExitStatus report_campaign(const campaign::Campaign& c, const CampaignDirectory& directory,
                           const campaign::Execution& result) {
  print(campaign::text_report(c, result) + campaign::leftover_report(directory.leftovers(c)));
  const std::filesystem::path& path = directory.files().path();
  if (std::filesystem::exists(path / "table.csv"))
    fmt::print("results in {}: report.html, table.csv{}, one directory per run with its log.txt\n",
               files::escaped(path.string()), c.seeds.size() > 1 ? ", means.csv" : "");
  if (result.interrupted) {
    fmt::print("interrupted; run the same command again to continue\n");
    return ExitStatus::interrupted;
  }
  if (result.count(campaign::Status::failed))
    return result.blew_up ? ExitStatus::blow_up : ExitStatus::failure;
  const auto is_met = [](const campaign::Outcome& o) { return o.unmet() == 0; };
  const bool met = std::all_of(result.outcomes.begin(), result.outcomes.end(), is_met) &&
                   std::all_of(result.preparations.begin(), result.preparations.end(), is_met);
  return met ? ExitStatus::success : ExitStatus::failure;
}

ExitStatus print_tasks(const campaign::Campaign& c, const CampaignArguments& a,
                       const campaign::ExecutionOptions& options, PluginHost& host) {
  CampaignDirectory directory(directory_of(c, a), c, true);
  campaign::check(c, directory, options, host);
  campaign::write_report(c, campaign::gathered(c, directory, host), directory);
  const campaign::TaskNumbers numbers = campaign::list_tasks(
      c, directory, a.per_task, [](const campaign::Point&) { return true; }, host);
  const std::string command = campaign::shell_line(command_of(c, a));
  const auto add = [&](std::size_t number) { fmt::print("{} --task {}\n", command, number); };
  for (const std::size_t number : numbers.preparations) add(number);
  for (const std::vector<std::size_t>& of : numbers.points)
    for (const std::size_t number : of) add(number);
  return ExitStatus::success;
}

ExitStatus do_task(const campaign::Campaign& c, const CampaignArguments& a,
                   const campaign::ExecutionOptions& options, PluginHost& host) {
  const std::size_t number = number_of(a.task);
  CampaignDirectory directory(directory_of(c, a), c, false);
  campaign::TaskOptions task;
  if (const char* restarts = std::getenv("SLURM_RESTART_COUNT"))
    task.restarts = unsigned(std::strtoul(restarts, nullptr, 10));
  const campaign::Execution result = campaign::run_task(c, directory, number, options, task, host);
  // Expectations are judged when all runs are there: another status would stop what depends on this task.
  if (result.interrupted) return ExitStatus::interrupted;
  for (const campaign::Outcome& outcome : result.outcomes)
    if (outcome.status != campaign::Status::finished)
      fmt::print("{}\n", files::one_line(outcome.problem, 1000));
  if (result.count(campaign::Status::finished) == result.outcomes.size()) return ExitStatus::success;
  return result.blew_up ? ExitStatus::blow_up : ExitStatus::failure;
}

ExitStatus gather(const campaign::Campaign& c, const CampaignArguments& a, const PluginHost& host) {
  const std::filesystem::path path = directory_of(c, a);
  if (!std::filesystem::is_directory(path))
    throw Error(path.string(), "holds no campaign", "run or submit it first, or give its --out");
  wait_for_directory(path);
  CampaignDirectory directory(path, c, true);
  const campaign::Execution result = campaign::gathered(c, directory, host);
  campaign::write_report(c, result, directory);
  campaign::write_page(directory);
  if (c.preparation) print(campaign::stopped_report(*c.preparation, result.preparations));
  print(campaign::stopped_report(c, result.outcomes));
  const ExitStatus status = report_campaign(c, directory, result);
  const bool all = result.count(campaign::Status::finished) == result.outcomes.size();
  return all ? status : std::max(status, ExitStatus::failure);
}

ExitStatus submit(const campaign::Campaign& c, const CampaignArguments& a,
                  const campaign::ExecutionOptions& options, PluginHost& host) {
  const std::vector<std::string> command = command_of(c, a);
  campaign::Submission submitted;
  {
    CampaignDirectory directory(directory_of(c, a), c, true);
    directory.files().report_lock(report_warning);
    const unsigned jobs = std::max(1u, a.jobs);
    campaign::SubmissionOptions submission{c.slurm, a.per_task, a.ranks > 0 ? a.ranks * jobs : 1,
                                           a.ranks > 0 ? a.threads : a.threads * jobs, command};
    if (!a.partition.empty()) submission.site.partition = a.partition;
    if (!a.time.empty()) submission.site.time = a.time;
    submitted = campaign::submit(c, directory, submission, options, host);
  }
  if (submitted.runs == 0 && submitted.before == 0) return gather(c, a, host);
  std::vector<std::string> list = {"scree", "campaign", c.source.string()};
  if (!a.out.empty()) list.insert(list.end(), {"--out", directory_of(c, a).string()});
  print(submission_report(submitted, campaign::shell_line(list)));
  return ExitStatus::success;
}

}  // namespace scree::tool
