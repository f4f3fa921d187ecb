#include "studies/studies.hpp"
#include "support/accuracy_arguments.hpp"
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
    const double wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    bar.show(share, wall_time, what);
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
  auto a = std::make_shared<AccuracyArguments>();
  Verb verb = add_accuracy_options(line, *a);
  verb.action([a] { return study_scenario(*a); });
}

}  // namespace scree::tool
