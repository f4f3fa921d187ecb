#include "course_report.hpp"
#include "measurement_report.hpp"
#include "run_report.hpp"
#include "verbs.hpp"

#include <memory>

#include <fmt/format.h>

#include <scree/run/run.hpp>

namespace scree::tool {

namespace {

struct ResumeArguments {
  std::string directory, checkpoint_every;
  std::vector<std::string> overrides;
  double until = 0;  // (s); 0: as before
  unsigned threads = 1;
  bool quiet = false;
  PluginOptions plugins;
};

// What changes a run changes no other results.
void refuse_changes(const ResumeArguments& arguments, const char* results) {
  if (!arguments.overrides.empty() || arguments.until > 0 || !arguments.checkpoint_every.empty())
    throw Error(fmt::format(
        "{}: holds a {}, which goes on as it began; give no --set, --until and --checkpoint-every",
        arguments.directory, results));
}

// Where they are, and with how many threads they go on.
template <class Options>
Options in_place_of(const ResumeArguments& arguments, Options options) {
  options.out = arguments.directory;
  options.threads = arguments.threads;
  return options;
}

ExitStatus resume(const ResumeArguments& arguments) {
  PluginHost host = make_host(arguments.plugins);
  if (sound::is_measurement(arguments.directory)) {
    refuse_changes(arguments, "spectrum");
    return report_measurement(arguments.quiet, [&](sound::MeasurementOptions options) {
      return sound::resume_measurement(in_place_of(arguments, options), host);
    });
  }
  if (std::filesystem::exists(std::filesystem::path(arguments.directory) / "campaign.json"))
    throw Error(
        fmt::format("{}: holds a campaign; repeat scree campaign with its file, which goes on with its runs",
                    arguments.directory));
  if (quasi_static::is_response(arguments.directory)) {
    refuse_changes(arguments, "response");
    return report_course(arguments.quiet, [&](quasi_static::FollowOptions options) {
      return quasi_static::resume_following(in_place_of(arguments, options), host);
    });
  }
  run::ResumeChanges changes;
  changes.overrides = arguments.overrides;
  if (arguments.until > 0) changes.until = arguments.until;
  if (!arguments.checkpoint_every.empty())
    changes.checkpoint_every = wall_time_option("--checkpoint-every", arguments.checkpoint_every);
  const run::RunResult result = with_progress(arguments.quiet, [&](run::RunOptions options) {
    return run::resume_run(in_place_of(arguments, options), changes, host);
  });
  return report_run(result, arguments.quiet);
}

}  // namespace

void add_resume_verb(CommandLine& line) {
  Verb verb = line.verb(
      "resume",
      "Go on with a run, a spectrum or a quasi-static load from its latest state, to the same bits");
  auto arguments = std::make_shared<ResumeArguments>();
  verb.option("directory", arguments->directory, "Directory of the run, spectrum or response").required();
  verb.option("--until", arguments->until,
              "Time (s) at which the last stage is to end; prolongs a finished run")
      .above_zero()
      .shown_as("SECONDS");
  verb.option("--set", arguments->overrides,
              "Change how long a stage lasts, for example --set stage.cycle.duration=5")
      .shown_as("KEY=VALUE");
  verb.option("--threads", arguments->threads,
              "Number of threads; results are bitwise identical for any number (default 1)")
      .between(1, 1024);
  add_checkpoint_option(verb, arguments->checkpoint_every);
  verb.flag("--quiet", arguments->quiet,
            "Print only warnings, unmet expectations and the location of the results");
  add_plugin_options(verb, arguments->plugins);
  verb.footer("Example: scree resume runs/first --until 0.5");
  verb.action([arguments] { return resume(*arguments); });
}

}  // namespace scree::tool
