#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <scree/scenario/plan.hpp>
#include <scree/simulation.hpp>

namespace scree::run {

// Which points charts of a scene will leave out at its start, as far as that is known before a run: a line
// "chart <name>: ..." for each.
std::vector<std::string> left_out_at_start(const scenario::Plan& plan, const Simulation& simulation);

// Which charts of a finished run or study are drawn again.
struct ChartRequest {
  std::filesystem::path run;           // its directory
  std::filesystem::path scenario;      // with the tables [[chart]]; empty: scenario.toml of the run
  std::vector<std::string> overrides;  // "key=value", of this scenario
  std::filesystem::path out;           // folder of the pictures; empty: charts/ of the run
  bool overwrite = false;              // whether files that the run did not write may be replaced
};

// Draws charts from the series of a run, or the tables of a study. drawn: is called with each file. Throws
// Error "<place>: <what is wrong>; <cure>".
void redraw_charts(const ChartRequest& request,
                   const std::function<void(const std::filesystem::path&)>& drawn);

}  // namespace scree::run
