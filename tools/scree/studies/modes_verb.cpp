#include "studies/studies.hpp"
#include "support/modes_arguments.hpp"
#include "support/study_tables.hpp"
#include "support/verbs.hpp"
#include "support/watched_work.hpp"

#include <memory>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include <scree/files/text.hpp>
#include <scree/modes/vibration.hpp>
#include <scree/spectrum/spectrum_plan.hpp>

namespace scree::tool {

namespace {

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
  auto a = std::make_shared<ModesArguments>();
  Verb verb = add_modes_options(line, *a);
  verb.action([a] { return find_modes(*a); });
}

}  // namespace scree::tool
