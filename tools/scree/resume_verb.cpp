#include "program_verbs.hpp"
#include "run_report.hpp"
#include "support/resume_arguments.hpp"
#include "support/study_tables.hpp"

#include <fmt/format.h>

#include <scree/run/result_kind.hpp>
#include <scree/run/run.hpp>

namespace scree::tool {

namespace {

ExitStatus resume(const ResumeArguments& arguments) {
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
    return run::resume_run(in_place_of(arguments, options), changes, host, study_tables());
  });
  return report_run(result, arguments.quiet);
}

}  // namespace

void add_resume_verb(CommandLine& line, const std::function<ExitStatus()>& resume_study) {
  auto arguments = std::make_shared<ResumeArguments>();
  Verb verb = add_resume_options(line, *arguments);
  verb.action([arguments, resume_study] {
    const bool of_study = run::has_results(arguments->directory, run::spectrum_results) ||
                          run::has_results(arguments->directory, run::quasi_static_results);
    return of_study ? resume_study() : resume(*arguments);
  });
}

}  // namespace scree::tool
