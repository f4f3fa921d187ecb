#include "studies/studies.hpp"
#include "support/study_tables.hpp"
#include "support/verbs.hpp"
#include "support/watched_work.hpp"

#include <memory>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include <scree/files/text.hpp>
#include <scree/modes/vibration.hpp>
#include <scree/pictures/render_options.hpp>
#include <scree/spectrum/spectrum_plan.hpp>

namespace scree::tool {

namespace {

struct ModesArguments {
  std::string scenario, out;
  std::string pictures, view;
  std::vector<std::string> overrides;
  unsigned threads = 1, modes = 20, density = 0;
  double near_hz = 0, density_to_hz = 0, residual_limit = 0.01;
  int fewest_contacts = 0;
  bool contacts_slide = false;
  bool elastic = false, loads = false, overwrite = false, quiet = false;
  PluginOptions plugins;
};

// "1,4,7".
std::vector<unsigned> numbers_of(const std::string& text) {
  std::vector<unsigned> numbers;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const bool digits = !part.empty() && part.size() < 7 && part.find_first_not_of("0123456789") == part.npos;
    const unsigned number = digits ? unsigned(std::stoul(part)) : 0;
    if (number == 0)
      throw Error(fmt::format("--picture {}: '{}' is not the number of a mode; give numbers from 1 as 1,4,7",
                              text, part));
    numbers.push_back(number);
  }
  return numbers;
}

modes::VibrationOptions options_of(const ModesArguments& a) {
  modes::VibrationOptions options;
  options.out = a.out;
  options.overwrite = a.overwrite;
  options.threads = a.threads;
  options.modes = a.modes;
  options.near_hz = a.near_hz;
  options.elastic = a.elastic;
  options.loads = a.loads;
  options.density = a.density;
  options.density_to_hz = a.density_to_hz;
  options.fewest_contacts = a.fewest_contacts;
  options.contacts_slide = a.contacts_slide;
  options.residual_limit = a.residual_limit;
  options.pictures = numbers_of(a.pictures);
  options.view = a.view;
  return options;
}

modes::Vibration solve_with_progress(const ModesArguments& arguments) {
  ProgressBar bar(arguments.quiet);
  PluginHost host = make_host(arguments.plugins);
  const scenario::Plan plan =
      scenario::read_plan(arguments.scenario, arguments.overrides, host, study_tables());
  modes::VibrationOptions options = options_of(arguments);
  if (const auto spectrum = spectrum::read_spectrum(plan)) {
    options.contacts_slide |= spectrum->linear.contacts_slide;
    if (options.fewest_contacts == 0) options.fewest_contacts = spectrum->linear.fewest_contacts;
  }
  return modes::vibrate(plan, watched(std::move(options), bar));
}

ExitStatus find_modes(const ModesArguments& arguments) {
  const modes::Vibration vibration = solve_with_progress(arguments);
  if (!arguments.quiet)
    fmt::print("{}", files::escaped(modes::text_report(vibration), files::Escapes::lines));
  if (vibration.interrupted) fmt::print("interrupted; what was complete is saved\n");
  fmt::print("results in {}\n", files::escaped(vibration.directory.string()));
  return vibration.interrupted ? ExitStatus::interrupted : ExitStatus::success;
}

}  // namespace

void add_modes_verb(CommandLine& line) {
  Verb verb = add_study_verb(line, "modes");
  auto a = std::make_shared<ModesArguments>();
  const std::vector<std::string> views(pictures::view_names.begin(), pictures::view_names.end());
  verb.option("scenario", a->scenario,
              "Scenario file (TOML), which begins from a state, or comes to rest in its stages")
      .required();
  verb.option("--modes", a->modes, "Number of modes (default 20)").between(1, 100000);
  verb.option("--near", a->near_hz, "Modes nearest to this frequency; default: the lowest")
      .above_zero()
      .shown_as("HZ");
  verb.flag("--elastic", a->elastic,
            "Elastic constants too, of a packing between two walls that is periodic otherwise");
  verb.flag(
      "--loads", a->loads,
      "Straight paths of walls, bodies and contact forces under growing loads on walls that forces move");
  verb.moved("--quasi-static", "--quasi-static is a command of its own: scree quasi-static SCENARIO");
  verb.option("--density", a->density,
              "Count the modes at this number of frequencies too, for the density of states")
      .between(2, 100000);
  verb.option("--density-to", a->density_to_hz, "Highest of these frequencies; default: above all modes")
      .above_zero()
      .shown_as("HZ");
  verb.option("--picture", a->pictures, "Draw these modes as arrows: 1,4,7").shown_as("K,K,...");
  verb.option("--view", a->view, "View direction of the pictures (default iso; always z in 2D)")
      .one_of(views);
  verb.option("--fewest-contacts", a->fewest_contacts,
              "Bodies with fewer are left out (default: 2 with friction, else dimension + 1)")
      .between(1, 100);
  verb.flag(
      "--sliding", a->contacts_slide,
      "Contacts at the limit of friction slide on, one way; default: they stick, as small oscillations make them");
  verb.option("--residual", a->residual_limit,
              "Modes with a residual above are named: |K q - w^2 M q| over w^2 M q (default 0.01)")
      .above_zero();
  verb.option("--set", a->overrides, "Change a value of the scenario").shown_as("KEY=VALUE");
  verb.option("--threads", a->threads, "Number of threads, for stages and counts (default 1)")
      .between(1, 1024);
  verb.option("--out", a->out, "Directory of the results; default runs/<scenario>-modes").shown_as("DIR");
  verb.flag("--overwrite", a->overwrite, "Replace existing results in the directory");
  verb.flag("--quiet", a->quiet, "Print only warnings and the location of the results");
  add_plugin_options(verb, a->plugins);
  verb.footer(
      "The packing is taken as it is at the end of the stages, with its contacts sticking (--sliding: sliding on).\n"
      "Modes are those of the symmetric part of its stiffness; residuals are those with all of it.\n"
      "Example: scree modes scenarios/lemrich2017/spectrum.toml --elastic --modes 40");
  verb.action([a] { return find_modes(*a); });
}

}  // namespace scree::tool
