#pragma once

#include "support/verbs.hpp"

#include <string>
#include <vector>

namespace scree::tool {

// What `scree quasi-static` takes.
struct QuasiStaticArguments {
  std::string scenario, out;
  std::vector<std::string> overrides;
  unsigned threads = 1, increments = 40;
  bool overwrite = false, quiet = false;
  PluginOptions plugins;
};

// Adds the verb `quasi-static` with its options; the caller gives it its action.
Verb add_quasi_static_options(CommandLine& line, QuasiStaticArguments& arguments);

}  // namespace scree::tool
