#include "studies/load_report.hpp"
#include "studies/studies.hpp"
#include "support/study_tables.hpp"
#include "support/verbs.hpp"

#include <memory>
#include <string>
#include <vector>

#include <scree/error.hpp>

namespace scree::tool {

namespace {

struct QuasiStaticArguments {
  std::string scenario, out;
  std::vector<std::string> overrides;
  unsigned threads = 1, increments = 40;
  bool overwrite = false, quiet = false;
  PluginOptions plugins;
};

ExitStatus follow(const QuasiStaticArguments& arguments) {
  return report_load(arguments.quiet, [&](quasi_static::FollowOptions options) {
    options.out = arguments.out;
    options.overwrite = arguments.overwrite;
    options.threads = arguments.threads;
    options.increments = arguments.increments;
    PluginHost host = make_host(arguments.plugins);
    return quasi_static::follow(
        scenario::read_plan(arguments.scenario, arguments.overrides, host, study_tables()), options);
  });
}

// Options of `modes`, with which both were one command.
void refuse_options_of_modes(Verb& verb) {
  for (const char* name : {"--modes", "--near", "--elastic", "--loads", "--density", "--density-to",
                           "--picture", "--view", "--fewest-contacts", "--sliding", "--residual"})
    verb.moved(name, std::string(name) + " belongs to scree modes, which finds modes; leave it out");
}

}  // namespace

void add_quasi_static_verb(CommandLine& line) {
  Verb verb = add_study_verb(line, "quasi-static");
  auto a = std::make_shared<QuasiStaticArguments>();
  verb.option("scenario", a->scenario, "Scenario file (TOML) whose last stage is the load").required();
  verb.option("--increments", a->increments,
              "Increments of each period of that stage, or of all of it if it has none (default 40)")
      .between(1, 1000000);
  verb.option("--set", a->overrides, "Change a value of the scenario").shown_as("KEY=VALUE");
  verb.option("--threads", a->threads, "Number of threads, for the stages before (default 1)")
      .between(1, 1024);
  verb.option("--out", a->out, "Directory of the results; default runs/<scenario>-quasi-static")
      .shown_as("DIR");
  verb.flag("--overwrite", a->overwrite, "Replace existing results in the directory");
  verb.flag("--quiet", a->quiet, "Print only warnings and the location of the results");
  add_plugin_options(verb, a->plugins);
  refuse_options_of_modes(verb);
  verb.footer(
      "The stages but the last run first, by dynamics; the last one is followed through states of equilibrium,\n"
      "without inertia and dashpots, with dynamics where no equilibrium is near.\n"
      "Example: scree quasi-static scenarios/mcnamara2008/biaxial.toml");
  verb.action([a] { return follow(*a); });
}

}  // namespace scree::tool
