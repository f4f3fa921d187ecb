#include "support/quasi_static_arguments.hpp"

namespace scree::tool {

namespace {

// Options of `modes`, with which both were one command.
void refuse_options_of_modes(Verb& verb) {
  for (const char* name : {"--modes", "--near", "--elastic", "--loads", "--density", "--density-to",
                           "--picture", "--view", "--fewest-contacts", "--sliding", "--residual"})
    verb.moved(name, std::string(name) + " belongs to scree modes, which finds modes; leave it out");
}

}  // namespace

Verb add_quasi_static_options(CommandLine& line, QuasiStaticArguments& a) {
  Verb verb = line.verb("quasi-static",
                        "The last stage of a scenario through states of equilibrium, without dynamics");
  verb.option("scenario", a.scenario, "Scenario file (TOML) whose last stage is the load").required();
  verb.option("--increments", a.increments,
              "Increments of each period of that stage, or of all of it if it has none (default 40)")
      .between(1, 1000000);
  verb.option("--set", a.overrides, "Change a value of the scenario").shown_as("KEY=VALUE");
  verb.option("--threads", a.threads, "Number of threads, for the stages before (default 1)")
      .between(1, 1024);
  verb.option("--out", a.out, "Directory of the results; default runs/<scenario>-quasi-static")
      .shown_as("DIR");
  verb.flag("--overwrite", a.overwrite, "Replace existing results in the directory");
  verb.flag("--quiet", a.quiet, "Print only warnings and the location of the results");
  add_plugin_options(verb, a.plugins);
  refuse_options_of_modes(verb);
  verb.footer(
      "The stages but the last run first, by dynamics; the last one is followed through states of equilibrium,\n"
      "without inertia and dashpots, with dynamics where no equilibrium is near.\n"
      "Example: scree quasi-static scenarios/mcnamara2008/biaxial.toml");
  return verb;
}

}  // namespace scree::tool
