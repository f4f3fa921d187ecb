#pragma once

#include <string>
#include <vector>

#include <scree/document/table.hpp>
#include <scree/scenario/plan.hpp>

namespace scree::scenario {

// Columns of the series of a probe; the first is time.
struct ProbeColumns {
  std::string probe;
  std::vector<std::string> names, units;
};

// Reads the tables [[chart]] of a scene. Throws Error "<place>: <what is wrong>; <cure>".
std::vector<ChartPlan> read_charts(const document::Table& root, const std::vector<ProbeColumns>& probes);

}  // namespace scree::scenario
