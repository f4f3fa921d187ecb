#include "over_ranks.hpp"
#include "program_verbs.hpp"
#include "run_report.hpp"
#include "support/resume_arguments.hpp"
#include "support/study_tables.hpp"

#include <fmt/format.h>

#include <scree/run/result_kind.hpp>
#include <scree/run/run.hpp>

namespace scree::tool {

namespace {

ExitStatus resume(const ResumeArguments& arguments, Ranks* ranks) {
  PluginHost host = make_host(arguments.plugins);
  if (std::filesystem::exists(std::filesystem::path(arguments.directory) / "campaign.json"))
    throw Error(
        fmt::format("{}: holds a campaign; repeat scree campaign with its file, which goes on with its runs",
                    arguments.directory));
  run::ResumeChanges changes;
  changes.overrides = arguments.overrides;
  if (arguments.until > 0) changes.until = arguments.until;
  changes.from = arguments.from;
  if (!arguments.checkpoint_every.empty())
    changes.checkpoint_every = wall_time_option("--checkpoint-every", arguments.checkpoint_every);
  const run::RunResult result = with_progress(arguments.quiet, [&](run::RunOptions options) {
    options.overwrite = arguments.overwrite;
    options.ranks = ranks;
    return run::resume_run(in_place_of(arguments, options), changes, host, study_tables());
  });
  return report_run(result, arguments.quiet);
}

}  // namespace

void add_resume_verb(CommandLine& line, const std::function<ExitStatus()>& resume_study) {
  auto arguments = std::make_shared<ResumeArguments>();
  Verb verb = add_resume_options(line, *arguments);
  add_ranks_option(verb, arguments->over_ranks);
  verb.action([arguments, resume_study] {
    const bool of_study = run::has_results(arguments->directory, run::spectrum_results) ||
                          run::has_results(arguments->directory, run::quasi_static_results);
    if (of_study && arguments->over_ranks)
      throw Error(
          fmt::format("{}: only a run is computed over ranks; leave out --ranks", arguments->directory));
    if (of_study) return resume_study();
    return do_over_ranks({arguments->over_ranks, arguments->threads, arguments->plugins},
                         [&](Ranks* ranks) { return resume(*arguments, ranks); });
  });
}

}  // namespace scree::tool
