#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include <scree/fields/grid_request.hpp>
#include <scree/plugin_host.hpp>

namespace scree::tool {

struct FieldsOptions {
  std::vector<std::filesystem::path> sources;  // states (.h5) and frames (.vtp)
  std::filesystem::path out;                   // .csv or .vti
  bool average = false, overwrite = false;
  unsigned threads = 1;
  std::optional<std::filesystem::path> state_of_frames;  // absent: the last of the run of a frame
  std::optional<double> density_of_frames;               // (kg/m³) instead of a state
  std::function<fields::GridRequest(int dimension)> request;
};

// Writes the fields of states and frames and prints what the balances leave open. Throws Error.
void write_fields(const FieldsOptions& options, PluginHost& host);

}  // namespace scree::tool
