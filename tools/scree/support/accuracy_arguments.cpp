#include "support/accuracy_arguments.hpp"

#include <scree/integration.hpp>

namespace scree::tool {

namespace {

std::vector<std::string> integrator_names() {
  std::vector<std::string> names;
  for (const IntegrationTraits& traits : integrations()) names.emplace_back(traits.name);
  return names;
}

}  // namespace

Verb add_accuracy_options(CommandLine& line, AccuracyArguments& a) {
  Verb verb =
      line.verb("accuracy", "Compare run time and error of a scenario for several steps and integrators");
  verb.option("scenario", a.scenario, "Scenario file (TOML); compares the quantities of its [[expect]]s")
      .required();
  verb.option("--out", a.out, "Directory of the study; default runs/<scenario>-accuracy").shown_as("DIR");
  verb.option("--tolerance", a.tolerance, "Maximum relative error of the cheapest setting (default 1e-3)")
      .above_zero();
  verb.option("--coarsest", a.coarsest, "Longest step, in units of the scenario's step (default 4)")
      .above_zero();
  verb.option("--count", a.count, "Number of steps, each half of the previous (default 6)").between(2, 20);
  verb.option("--integrator", a.integrators, "Use only this one; repeatable; default all")
      .one_of(integrator_names());
  verb.option(
          "--quantity", a.quantities,
          "Compare this one, as [[expect]] names it, in place of those of [[expect]]; repeatable. A peak, "
          "peaks.pulse.strain.strain.3lambda/4, stands for its frequency and quality")
      .shown_as("NAME");
  verb.option("--set", a.overrides, "Change a value of the scenario").shown_as("KEY=VALUE");
  verb.flag("--overwrite", a.overwrite, "Replace an existing study in the directory");
  verb.flag("--quiet", a.quiet, "Print only the verdict");
  add_plugin_options(verb, a.plugins);
  verb.footer(
      "Example: scree accuracy scenarios/david2005/quickstart.toml --tolerance 1e-3 --out runs/accuracy\n"
      "         scree accuracy scenarios/sound/chain.toml --quantity peaks.pulse.particles.z_8.peak_2 --tolerance 1e-4 "
      "--integrator velocity_verlet");
  return verb;
}

}  // namespace scree::tool
