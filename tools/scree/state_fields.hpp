#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include <scree/fields/grid_request.hpp>
#include <scree/plugin_host.hpp>

namespace scree::tool {

struct FieldsOptions {
  std::vector<std::filesystem::path> states;
  std::filesystem::path out;  // .csv or .vti
  bool average = false, overwrite = false;
  unsigned threads = 1;
  std::function<fields::GridRequest(int dimension)> request;
};

// Writes the fields of states and prints what the balances leave open. Throws Error.
void write_fields(const FieldsOptions& options, PluginHost& host);

}  // namespace scree::tool
