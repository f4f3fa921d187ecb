#include "studies/studies.hpp"
#include "support/progress_bar.hpp"
#include "support/study_tables.hpp"
#include "support/verbs.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include <scree/accuracy/report.hpp>
#include <scree/accuracy/study.hpp>
#include <scree/files/text.hpp>

namespace scree::tool {

namespace {

struct AccuracyArguments {
  std::string scenario, out;
  std::vector<std::string> overrides, integrators, quantities;
  double tolerance = 1e-3, coarsest = 4;
  int count = 6;
  bool overwrite = false, quiet = false;
  PluginOptions plugins;
};

std::vector<std::string> integrator_names() {
  std::vector<std::string> names;
  for (const IntegrationTraits& traits : integrations()) names.emplace_back(traits.name);
  return names;
}

accuracy::RecordedStudyOptions options_of(const AccuracyArguments& arguments, ProgressBar& bar) {
  accuracy::RecordedStudyOptions options;
  options.out = arguments.out;
  options.overwrite = arguments.overwrite;
  options.tolerance = arguments.tolerance;
  options.coarsest = arguments.coarsest;
  options.count = arguments.count;
  for (const IntegrationTraits& traits : integrations())
    if (std::find(arguments.integrators.begin(), arguments.integrators.end(), traits.name) !=
        arguments.integrators.end())
      options.integrations.push_back(traits.integration);
  options.quantities = arguments.quantities;
  options.stop = &watch_for_interrupt();
  const auto start = std::chrono::steady_clock::now();
  options.on_progress = [&bar, start](double share, const std::string& what) {
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    bar.show(share, wall, what);
  };
  options.on_warning = [&bar](const std::string& line) {
    bar.clear();
    report_warning(line);
  };
  // Printed before the files are written, which may fail.
  options.on_result = [&bar, quiet = arguments.quiet](const accuracy::Convergence& found) {
    bar.clear();
    if (quiet)
      fmt::print("{}\n", files::escaped(accuracy::verdict(found)));
    else
      fmt::print("{}", files::escaped(accuracy::text_report(found), files::Escapes::lines));
    std::fflush(stdout);
  };
  return options;
}

ExitStatus study_scenario(const AccuracyArguments& arguments) {
  PluginHost host = make_host(arguments.plugins);
  const scenario::Plan plan =
      scenario::read_plan(arguments.scenario, arguments.overrides, host, study_tables());
  const auto [found, directory] = [&] {
    ProgressBar bar(arguments.quiet);
    return accuracy::recorded_study(plan, options_of(arguments, bar));
  }();
  fmt::print("results in {}\n", files::escaped(directory.string()));
  const bool any = std::any_of(found.outcomes.begin(), found.outcomes.end(),
                               [](const accuracy::SettingResult& o) { return o.problem.empty(); });
  if (found.interrupted) return ExitStatus::interrupted;
  return any ? ExitStatus::success : ExitStatus::failure;
}

}  // namespace

void add_accuracy_verb(CommandLine& line) {
  Verb verb = add_study_verb(line, "accuracy");
  auto a = std::make_shared<AccuracyArguments>();
  verb.option("scenario", a->scenario, "Scenario file (TOML); compares the quantities of its [[expect]]s")
      .required();
  verb.option("--out", a->out, "Directory of the study; default runs/<scenario>-accuracy").shown_as("DIR");
  verb.option("--tolerance", a->tolerance, "Maximum relative error of the cheapest setting (default 1e-3)")
      .above_zero();
  verb.option("--coarsest", a->coarsest, "Longest step, in units of the scenario's step (default 4)")
      .above_zero();
  verb.option("--count", a->count, "Number of steps, each half of the previous (default 6)").between(2, 20);
  verb.option("--integrator", a->integrators, "Use only this one; repeatable; default all")
      .one_of(integrator_names());
  verb.option(
          "--quantity", a->quantities,
          "Compare this one, as [[expect]] names it, in place of those of [[expect]]; repeatable. A peak, "
          "peaks.pulse.strain.strain.3lambda/4, stands for its frequency and quality")
      .shown_as("NAME");
  verb.option("--set", a->overrides, "Change a value of the scenario").shown_as("KEY=VALUE");
  verb.flag("--overwrite", a->overwrite, "Replace an existing study in the directory");
  verb.flag("--quiet", a->quiet, "Print only the verdict");
  add_plugin_options(verb, a->plugins);
  verb.footer(
      "Example: scree accuracy scenarios/david2005/quickstart.toml --tolerance 1e-3 --out runs/accuracy\n"
      "         scree accuracy scenarios/sound/chain.toml --quantity peaks.pulse.particles.z_8.peak_2 --tolerance 1e-4 "
      "--integrator velocity_verlet");
  verb.action([a] { return study_scenario(*a); });
}

}  // namespace scree::tool
