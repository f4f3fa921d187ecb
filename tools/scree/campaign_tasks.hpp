#pragma once

#include "support/verbs.hpp"

#include <string>
#include <vector>

#include <scree/campaign/execution.hpp>
#include <scree/campaign/report.hpp>
#include <scree/campaign/submission.hpp>

namespace scree::tool {

struct CampaignArguments {
  std::vector<std::string> files;
  std::string out;
  unsigned jobs = 0, threads = 1, ranks = 0;  // jobs 0: as many as may be used; ranks 0: none
  std::vector<std::string> overrides;
  bool list = false, overwrite = false, quiet = false;
  // Of batch systems.
  std::string on, partition, time, task;
  unsigned per_task = 1;
  bool gather = false, print_tasks = false;
  PluginOptions plugins;
};

// The directory of one of the files: with several of them, a folder of its own in --out.
std::filesystem::path directory_of(const campaign::Campaign& c, const CampaignArguments& a);

// Throws Error for options that exclude each other.
void check_batch_options(const CampaignArguments& a);
// Throws Error if a batch system has runs of the directory, which a local campaign would do a second time.
void refuse_queued(const campaign::CampaignDirectory& directory);

// Prints what the runs in a directory have become and where the tables are; the exit status of a campaign.
ExitStatus report_campaign(const campaign::Campaign& c, const campaign::CampaignDirectory& directory,
                           const campaign::Execution& result);

// scree campaign FILE with --list, --print-tasks, --task, --gather, --on slurm.
ExitStatus list_points(const campaign::Campaign& c, const CampaignArguments& a, const PluginHost& host);
ExitStatus print_tasks(const campaign::Campaign& c, const CampaignArguments& a,
                       const campaign::ExecutionOptions& options, PluginHost& host);
ExitStatus do_task(const campaign::Campaign& c, const CampaignArguments& a,
                   const campaign::ExecutionOptions& options, PluginHost& host);
ExitStatus gather(const campaign::Campaign& c, const CampaignArguments& a, const PluginHost& host);
ExitStatus submit(const campaign::Campaign& c, const CampaignArguments& a,
                  const campaign::ExecutionOptions& options, PluginHost& host);

}  // namespace scree::tool
