#pragma once

#include "support/verbs.hpp"

#include <optional>
#include <string>
#include <vector>

#include <scree/fields/averaging_kernel.hpp>

namespace scree::tool {

// What `scree fields` takes.
struct FieldsArguments {
  std::vector<std::string> sources;
  std::string out, plane, lower, upper, kernel = fields::kernel_names[0], state;
  std::optional<double> width, spacing, density;
  bool average = false, overwrite = false;
  unsigned threads = 1;
  PluginOptions plugins;
};

// Adds the verb `fields` with its options; the caller gives it its action.
Verb add_fields_options(CommandLine& line, FieldsArguments& arguments);

}  // namespace scree::tool
