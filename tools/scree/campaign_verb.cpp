#include "campaign_tasks.hpp"
#include "program_verbs.hpp"
#include "support/progress_bar.hpp"
#include "support/study_tables.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include <fmt/format.h>

#include <scree/allowed_processors.hpp>
#include <scree/counted.hpp>

namespace scree::tool {

namespace {

campaign::ExecutionOptions options_of(const CampaignArguments& a, ProgressBar& bar) {
  campaign::ExecutionOptions options;
  options.studies = study_tables();
  options.jobs = a.jobs ? a.jobs : std::max(1u, allowed_processors() / (a.threads * std::max(1u, a.ranks)));
  options.threads = a.threads;
  options.ranks = a.ranks;
  options.again = a.overwrite;
  options.plugin_directories = a.plugins.directories;
  options.stop = &watch_for_interrupt();
  options.on_progress = [&bar](const campaign::Tally& t) {
    bar.show(t.share, t.wall_time,
             fmt::format("{} of {} done, {} running, {} failed", t.finished, counted(t.total, "run"),
                         t.running, t.failed));
  };
  options.on_warning = [&bar](const std::string& line) {
    bar.clear();
    report_warning(line);
  };
  options.on_check = [&bar](std::size_t checked, std::size_t total) {
    bar.show(0, 0, fmt::format("{} of {} checked", checked, counted(total, "run")));
  };
  return options;
}

// Refuses what the campaign itself would refuse.
ExitStatus checked_list(const campaign::Campaign& c, const CampaignArguments& a, PluginHost& host) {
  {
    campaign::CampaignDirectory directory(directory_of(c, a), c, false);
    ProgressBar bar(a.quiet);
    const campaign::ExecutionOptions options = options_of(a, bar);
    campaign::check(c, directory, options, host);
    if (*options.stop) return ExitStatus::interrupted;
  }
  return list_points(c, a, host);
}

campaign::Execution execute_with_bar(const campaign::Campaign& c, campaign::CampaignDirectory& directory,
                                     const CampaignArguments& a, PluginHost& host) {
  ProgressBar bar(a.quiet);
  return campaign::execute(c, directory, options_of(a, bar), host);
}

ExitStatus run_campaign(const campaign::Campaign& c, const CampaignArguments& a, PluginHost& host) {
  if (a.ranks > 0 && !c.methods.empty())
    throw Error(
        fmt::format("{}: spectra are measured by one process each; leave out --ranks", c.source.string()));
  if (a.list) return checked_list(c, a, host);
  if (a.gather) return gather(c, a, host);
  const auto with_bar = [&](auto* action) {
    ProgressBar bar(a.quiet);
    return action(c, a, options_of(a, bar), host);
  };
  if (a.print_tasks) return with_bar(print_tasks);
  if (!a.task.empty()) return with_bar(do_task);
  if (!a.on.empty()) return with_bar(submit);
  campaign::CampaignDirectory directory(directory_of(c, a), c, true);
  directory.files().report_lock(report_warning);
  refuse_queued(directory);
  return report_campaign(c, directory, execute_with_bar(c, directory, a, host));
}

// Throws Error (bad_input) if two have one directory.
std::vector<campaign::Campaign> read_campaigns(const CampaignArguments& a, PluginHost& host) {
  std::vector<campaign::Campaign> campaigns;
  std::map<std::filesystem::path, std::string> taken;
  for (const std::string& file : a.files) {
    campaigns.push_back(campaign::branched(campaign::read_campaign(file, a.overrides), host));
    const std::filesystem::path directory = directory_of(campaigns.back(), a);
    if (const auto [other, is_new] = taken.try_emplace(directory, file); !is_new)
      throw Error(fmt::format("{} and {} have the same directory, {}; rename one, or give two calls",
                              other->second, file, directory.string()));
  }
  return campaigns;
}

// Runs and directories of all, before the first begins.
void check_campaigns(const std::vector<campaign::Campaign>& campaigns, const CampaignArguments& a,
                     PluginHost& host) {
  ProgressBar bar(a.quiet);
  for (const campaign::Campaign& c : campaigns) {
    campaign::CampaignDirectory directory(directory_of(c, a), c, true);
    campaign::check(c, directory, options_of(a, bar), host);
  }
}

// One after the other, whether they fail or not; the exit status is the worst.
ExitStatus run_campaigns(const CampaignArguments& a) {
  check_batch_options(a);
  PluginHost host = make_host(a.plugins);
  const std::vector<campaign::Campaign> campaigns = read_campaigns(a, host);
  const bool runs = !a.list && !a.gather && !a.print_tasks && a.on.empty();
  if (campaigns.size() > 1 && runs) check_campaigns(campaigns, a, host);
  ExitStatus worst = ExitStatus::success;
  for (const campaign::Campaign& c : campaigns) {
    worst = std::max(worst, run_campaign(c, a, host));
    if (worst == ExitStatus::interrupted) break;
  }
  return worst;
}

void add_batch_options(Verb& verb, const std::shared_ptr<CampaignArguments>& a) {
  verb.option("--on", a->on,
              "Submit what has not finished to this batch system, and return; for others --print-tasks")
      .one_of({"slurm"});
  verb.option("--partition", a->partition, "Partition of the jobs; others in [slurm] of the file")
      .shown_as("NAME");
  verb.option("--time", a->time,
              "Limit of time of a task, as of sbatch: 4:00:00; a run that exceeds it goes on")
      .shown_as("TIME");
  verb.option("--per-task", a->per_task, "Runs in a task (default 1), for runs of seconds")
      .between(1, 100000);
  verb.flag("--print-tasks", a->print_tasks,
            "Print the tasks, a command each, for any batch system; run nothing");
  verb.option("--task", a->task, "Do task K of --print-tasks, from 0, unless it is done").shown_as("K");
  verb.flag(
      "--gather", a->gather,
      "Write the tables and the report of what has been run, status 1 if runs are missing; run nothing");
}

constexpr const char* campaign_footer =
    "What has finished is not run again, and interrupted runs go on from their last state: give the same call\n"
    "after Ctrl-C, a failure, or new values in the file. A campaign file:\n"
    "  [campaign]\n"
    "  scenario = \"../fall.toml\"               # relative to this file\n"
    "  seeds = [1, 2, 3]                       # or { first = 1, count = 20 }\n"
    "  collect = [\"energy.work.last\"]          # quantities as in [[expect]], for the table\n"
    "  spectrum = \"pulse\"                     # measures spectra by this method instead of running\n"
    "  [set]                                   # keys as in scree run --set\n"
    "  \"contact.static_friction\" = [0.1, 0.3]  # a list of values; all combinations are run\n"
    "  \"particles.lattice.count\" = [[5, 5, 8]] # a value that is itself a list\n"
    "  \"time.step\" = 1e-5                      # for all runs\n"
    "  [[case]]                                # a named set of values\n"
    "  name = \"soft\"\n"
    "  set.contact.normal_stiffness = 1000\n"
    "  prepare.boundary.lid.stress = 1e4       # of its preparation; without any, cases share those of the seeds\n"
    "  [prepare]                               # run first, for each seed; all runs begin from its final state\n"
    "  scenario = \"settle.toml\"\n"
    "  set.time.step = 1e-5                    # for the preparations; a list is a value\n"
    "Example: scree campaign scenarios/david2005/friction-campaign.toml --jobs 2 --set campaign.seeds=[1]";

}  // namespace

void add_campaign_verb(CommandLine& line) {
  Verb verb = line.verb("campaign", "Run a scenario for many parameters and seeds, several runs at a time");
  auto a = std::make_shared<CampaignArguments>();
  verb.option("file", a->files,
              "Campaign files (TOML), run one after the other: a scenario, seeds, lists of values")
      .required();
  verb.option("--out", a->out, "Directory of the campaign, of several <DIR>/<file>; default campaigns/<file>")
      .shown_as("DIR");
  verb.option("--jobs", a->jobs,
              "Concurrent runs (default: processors that may be used / threads; of a task 1)")
      .between(1, 512);
  verb.option("--threads", a->threads, "Threads of each run, or of each of its ranks (default 1)")
      .between(1, 1024);
  verb.option("--ranks", a->ranks,
              "Processes that compute each run together, started by mpirun, in jobs of Slurm by srun")
      .between(1, 100000)
      .shown_as("N");
  verb.option(
          "--set", a->overrides,
          "A line of [set], in place of that of the file; campaign.KEY of [campaign], prepare.KEY of [prepare]")
      .shown_as("KEY=VALUE");
  verb.flag("--list", a->list, "List each preparation and run with its status and job; run nothing");
  add_batch_options(verb, a);
  verb.flag("--overwrite", a->overwrite, "Begin all runs anew, also finished and interrupted ones");
  verb.flag("--quiet", a->quiet, "No progress, only the summary");
  add_plugin_options(verb, a->plugins);
  verb.footer(campaign_footer);
  verb.action([a] { return run_campaigns(*a); });
}

}  // namespace scree::tool
