#include "support/modes_arguments.hpp"

#include <scree/pictures/render_options.hpp>

namespace scree::tool {

Verb add_modes_options(CommandLine& line, ModesArguments& a) {
  Verb verb = line.verb(
      "modes",
      "Modes and elastic constants of a packing at rest, and its straight paths under growing loads");
  const std::vector<std::string> views(pictures::view_names.begin(), pictures::view_names.end());
  verb.option("scenario", a.scenario,
              "Scenario file (TOML), which begins from a state, or comes to rest in its stages")
      .required();
  verb.option("--modes", a.modes, "Number of modes (default 20)").between(1, 100000);
  verb.option("--near", a.near_hz, "Modes nearest to this frequency; default: the lowest")
      .above_zero()
      .shown_as("HZ");
  verb.flag("--elastic", a.elastic,
            "Elastic constants too, of a packing between two walls that is periodic otherwise");
  verb.flag(
      "--loads", a.loads,
      "Straight paths of walls, bodies and contact forces under growing loads on walls that forces move");
  verb.moved("--quasi-static", "--quasi-static is a command of its own: scree quasi-static SCENARIO");
  verb.option("--density", a.density,
              "Count the modes at this number of frequencies too, for the density of states")
      .between(2, 100000);
  verb.option("--density-to", a.density_to_hz, "Highest of these frequencies; default: above all modes")
      .above_zero()
      .shown_as("HZ");
  verb.option("--picture", a.pictures, "Draw these modes as arrows: 1,4,7").shown_as("K,K,...");
  verb.option("--view", a.view, "View direction of the pictures (default iso; always z in 2D)").one_of(views);
  verb.option("--fewest-contacts", a.fewest_contacts,
              "Bodies with fewer are left out (default: 2 with friction, else dimension + 1)")
      .between(1, 100);
  verb.flag(
      "--sliding", a.contacts_slide,
      "Contacts at the limit of friction slide on, one way; default: they stick, as small oscillations make them");
  verb.option("--residual", a.residual_limit,
              "Modes with a residual above are named: |K q - w^2 M q| over w^2 M q (default 0.01)")
      .above_zero();
  verb.option("--set", a.overrides, "Change a value of the scenario").shown_as("KEY=VALUE");
  verb.option("--threads", a.threads, "Number of threads, for stages and counts (default 1)")
      .between(1, 1024);
  verb.option("--out", a.out, "Directory of the results; default runs/<scenario>-modes").shown_as("DIR");
  verb.flag("--overwrite", a.overwrite, "Replace existing results in the directory");
  verb.flag("--quiet", a.quiet, "Print only warnings and the location of the results");
  add_plugin_options(verb, a.plugins);
  verb.footer(
      "The packing is taken as it is at the end of the stages, with its contacts sticking (--sliding: sliding on).\n"
      "Modes are those of the symmetric part of its stiffness; residuals are those with all of it.\n"
      "Example: scree modes scenarios/lemrich2017/spectrum.toml --elastic --modes 40");
  return verb;
}

}  // namespace scree::tool
