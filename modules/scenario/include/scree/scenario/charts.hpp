#pragma once

#include <functional>
#include <string>
#include <vector>

#include <scree/charts/chart_spec.hpp>
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

// Values of a column of a probe, "time" included; empty if it was never sampled.
using ColumnOf = std::function<std::vector<double>(const std::string& probe, const std::string& column)>;

// The chart of a plan, its axes in units with prefixes. Throws Error if no probe was sampled.
charts::ChartSpec chart_of(const ChartPlan& plan, const ColumnOf& column);

}  // namespace scree::scenario
