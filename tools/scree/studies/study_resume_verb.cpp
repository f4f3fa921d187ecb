#include "studies/load_report.hpp"
#include "studies/measurement_report.hpp"
#include "studies/studies.hpp"
#include "support/resume_arguments.hpp"

#include <fmt/format.h>

#include <scree/run/result_kind.hpp>

namespace scree::tool {

namespace {

// What changes a run changes no other results.
void refuse_changes(const ResumeArguments& arguments, const char* results) {
  if (!arguments.overrides.empty() || arguments.until > 0 || !arguments.checkpoint_every.empty() ||
      !arguments.from.empty())
    throw Error(fmt::format(
        "{}: holds a {}, which goes on as it began; give no --set, --until, --from and --checkpoint-every",
        arguments.directory, results));
}

ExitStatus resume(const ResumeArguments& arguments) {
  PluginHost host = make_host(arguments.plugins);
  if (run::has_results(arguments.directory, run::spectrum_results)) {
    refuse_changes(arguments, "spectrum");
    return report_measurement(arguments.quiet, [&](spectrum::MeasurementOptions options) {
      return spectrum::resume_measurement(in_place_of(arguments, options), host);
    });
  }
  refuse_changes(arguments, "quasi-static load");
  return report_load(arguments.quiet, [&](quasi_static::FollowOptions options) {
    return quasi_static::resume_following(in_place_of(arguments, options), host);
  });
}

}  // namespace

void add_study_resume_verb(CommandLine& line) {
  auto arguments = std::make_shared<ResumeArguments>();
  Verb verb = add_resume_options(line, *arguments);
  verb.action([arguments] { return resume(*arguments); });
}

}  // namespace scree::tool
