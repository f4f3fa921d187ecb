#include "studies/load_report.hpp"
#include "studies/studies.hpp"
#include "support/quasi_static_arguments.hpp"
#include "support/study_tables.hpp"
#include "support/verbs.hpp"

#include <memory>
#include <string>

namespace scree::tool {

namespace {

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

}  // namespace

void add_quasi_static_verb(CommandLine& line) {
  auto a = std::make_shared<QuasiStaticArguments>();
  Verb verb = add_quasi_static_options(line, *a);
  verb.action([a] { return follow(*a); });
}

}  // namespace scree::tool
