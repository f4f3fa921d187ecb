#pragma once

#include "support/verbs.hpp"

#include <string>
#include <vector>

namespace scree::tool {

// What `scree modes` takes.
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

// Adds the verb `modes` with its options; the caller gives it its action.
Verb add_modes_options(CommandLine& line, ModesArguments& arguments);

}  // namespace scree::tool
