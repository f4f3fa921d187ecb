#include "over_ranks.hpp"
#include "program_verbs.hpp"
#include "run_report.hpp"
#include "support/study_tables.hpp"

#include <memory>

#include <scree/run/run.hpp>

namespace scree::tool {

namespace {

struct RunArguments {
  std::string scenario, out, checkpoint_every;
  std::vector<std::string> overrides;
  unsigned threads = 1;
  bool overwrite = false, quiet = false, over_ranks = false;
  PluginOptions plugins;
};

ExitStatus run_scenario(const RunArguments& arguments, Ranks* ranks) {
  PluginHost host = make_host(arguments.plugins);
  scenario::Plan plan = scenario::read_plan(arguments.scenario, arguments.overrides, host, study_tables());
  if (!arguments.checkpoint_every.empty())
    plan.checkpoint.every = wall_time_option("--checkpoint-every", arguments.checkpoint_every);
  const run::RunResult result = with_progress(arguments.quiet, [&](run::RunOptions options) {
    options.out = arguments.out;
    options.overwrite = arguments.overwrite;
    options.threads = arguments.threads;
    options.ranks = ranks;
    if (options.on_start)
      options.on_start = [&plan, print = options.on_start](const Simulation& simulation) {
        print(simulation);
        print_sources(plan);
      };
    return run::run_plan(plan, options);
  });
  return report_run(result, arguments.quiet);
}

}  // namespace

void add_run_verb(CommandLine& line) {
  Verb verb = line.verb("run", "Run a scenario");
  auto arguments = std::make_shared<RunArguments>();
  verb.option("scenario", arguments->scenario, "Scenario file (TOML)").required();
  verb.option("--out", arguments->out, "Directory of the run; default runs/<scenario>, numbered if it exists")
      .shown_as("DIR");
  verb.option("--set", arguments->overrides,
              "Change a value of the scenario, for example --set contact.static_friction=0.2")
      .shown_as("KEY=VALUE");
  verb.option("--threads", arguments->threads,
              "Number of threads; results are bitwise identical for any number (default 1)")
      .between(1, 1024);
  add_ranks_option(verb, arguments->over_ranks);
  add_checkpoint_option(verb, arguments->checkpoint_every);
  verb.flag("--overwrite", arguments->overwrite, "Replace the files of an existing run in the directory");
  verb.flag("--quiet", arguments->quiet,
            "Print only warnings, unmet expectations and the location of the results");
  add_plugin_options(verb, arguments->plugins);
  verb.footer(
      "Example: scree run scenarios/david2005/quickstart.toml --out runs/first --set "
      "contact.static_friction=0.2\n"
      "         mpirun -n 8 scree run big.toml --ranks");
  verb.action([arguments] {
    return do_over_ranks({arguments->over_ranks, arguments->threads, arguments->plugins},
                         [&](Ranks* ranks) { return run_scenario(*arguments, ranks); });
  });
}

}  // namespace scree::tool
