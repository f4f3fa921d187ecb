#pragma once

#include "support/verbs.hpp"

#include <memory>
#include <string>
#include <vector>

namespace scree::tool {

// What `scree resume` takes, for runs and for studies.
struct ResumeArguments {
  std::string directory, checkpoint_every, from;
  std::vector<std::string> overrides;
  double until = 0;  // (s); 0: as before
  unsigned threads = 1;
  bool over_ranks = false, overwrite = false, quiet = false;
  PluginOptions plugins;
};

// Adds the verb `resume` with its options; the caller gives it its action.
Verb add_resume_options(CommandLine& line, ResumeArguments& arguments);

// Options of the work that goes on: where its results are, and with how many threads.
template <class Options>
Options in_place_of(const ResumeArguments& arguments, Options options) {
  options.out = arguments.directory;
  options.threads = arguments.threads;
  return options;
}

}  // namespace scree::tool
