#pragma once

#include "support/verbs.hpp"

#include <string>
#include <vector>

namespace scree::tool {

// What `scree accuracy` takes.
struct AccuracyArguments {
  std::string scenario, out;
  std::vector<std::string> overrides, integrators, quantities;
  double tolerance = 1e-3, coarsest = 4;
  int count = 6;
  bool overwrite = false, quiet = false;
  PluginOptions plugins;
};

// Adds the verb `accuracy` with its options; the caller gives it its action.
Verb add_accuracy_options(CommandLine& line, AccuracyArguments& arguments);

}  // namespace scree::tool
