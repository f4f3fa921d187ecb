#include "program_verbs.hpp"
#include "support/progress_bar.hpp"
#include "support/study_tables.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>

#include <fmt/format.h>

#include <scree/allowed_processors.hpp>
#include <scree/campaign/report.hpp>
#include <scree/counted.hpp>
#include <scree/files/text.hpp>

namespace scree::tool {

namespace {

struct CampaignArguments {
  std::vector<std::string> files;
  std::string out;
  unsigned jobs = 0, threads = 1;  // jobs 0: as many as the processor takes
  std::vector<std::string> overrides;
  bool list = false, overwrite = false, quiet = false;
  PluginOptions plugins;
};

// That of one of the files: with several of them, a folder of its own in --out.
std::filesystem::path directory_of(const campaign::Campaign& c, const CampaignArguments& a) {
  constexpr auto kind = run::RunDirectory::Kind::campaign;
  const std::filesystem::path own = run::RunDirectory::default_for(c.source, kind);
  if (a.out.empty()) return own;
  return a.files.size() > 1 ? std::filesystem::path(a.out) / own.filename() : std::filesystem::path(a.out);
}

campaign::ExecutionOptions options_of(const CampaignArguments& a, ProgressBar& bar) {
  campaign::ExecutionOptions options;
  options.studies = study_tables();
  options.jobs = a.jobs ? a.jobs : std::max(1u, allowed_processors() / a.threads);
  options.threads = a.threads;
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
ExitStatus list_points(const campaign::Campaign& c, const CampaignArguments& a, PluginHost& host) {
  campaign::CampaignDirectory directory(directory_of(c, a), c, false);
  {
    ProgressBar bar(a.quiet);
    const campaign::ExecutionOptions options = options_of(a, bar);
    campaign::check(c, directory, options, host);
    if (*options.stop) return ExitStatus::interrupted;
  }
  fmt::print("{}", files::escaped(campaign::list_report(c, directory.preparations(c, host),
                                                        directory.outcomes(c, host)) +
                                      campaign::leftover_report(directory.leftovers(c)),
                                  files::Escapes::lines));
  return ExitStatus::success;
}

campaign::Execution execute_with_bar(const campaign::Campaign& c, campaign::CampaignDirectory& directory,
                                     const CampaignArguments& a, PluginHost& host) {
  ProgressBar bar(a.quiet);
  return campaign::execute(c, directory, options_of(a, bar), host);
}

ExitStatus run_campaign(const campaign::Campaign& c, const CampaignArguments& a, PluginHost& host) {
  if (a.list) return list_points(c, a, host);
  campaign::CampaignDirectory directory(directory_of(c, a), c, true);
  directory.files().report_lock(report_warning);
  const campaign::Execution result = execute_with_bar(c, directory, a, host);
  fmt::print("{}", files::escaped(
                       campaign::text_report(c, result) + campaign::leftover_report(directory.leftovers(c)),
                       files::Escapes::lines));
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
  PluginHost host = make_host(a.plugins);
  const std::vector<campaign::Campaign> campaigns = read_campaigns(a, host);
  if (campaigns.size() > 1 && !a.list) check_campaigns(campaigns, a, host);
  ExitStatus worst = ExitStatus::success;
  for (const campaign::Campaign& c : campaigns) {
    worst = std::max(worst, run_campaign(c, a, host));
    if (worst == ExitStatus::interrupted) break;
  }
  return worst;
}

}  // namespace

void add_campaign_verb(CommandLine& line) {
  Verb verb = line.verb("campaign", "Run a scenario for many parameters and seeds, several runs at a time");
  auto a = std::make_shared<CampaignArguments>();
  verb.option("file", a->files,
              "Campaign files (TOML), run one after the other: a scenario, seeds, lists of values")
      .required();
  verb.option("--out", a->out, "Directory of the campaign, of several <DIR>/<file>; default campaigns/<file>")
      .shown_as("DIR");
  verb.option("--jobs", a->jobs, "Concurrent runs (default: processors / threads)").between(1, 512);
  verb.option("--threads", a->threads, "Threads of each run (default 1)").between(1, 1024);
  verb.option(
          "--set", a->overrides,
          "A line of [set], in place of that of the file; campaign.KEY of [campaign], prepare.KEY of [prepare]")
      .shown_as("KEY=VALUE");
  verb.flag("--list", a->list, "List each preparation and run with its status; run nothing");
  verb.flag("--overwrite", a->overwrite, "Begin all runs anew, also finished and interrupted ones");
  verb.flag("--quiet", a->quiet, "No progress, only the summary");
  add_plugin_options(verb, a->plugins);
  verb.footer(
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
      "Example: scree campaign scenarios/david2005/friction-campaign.toml --jobs 2 --set campaign.seeds=[1]");
  verb.action([a] { return run_campaigns(*a); });
}

}  // namespace scree::tool
