#pragma once

#include <string>
#include <vector>

#include <scree/document/table.hpp>
#include <scree/scenario/charts.hpp>
#include <scree/scenario/plan.hpp>

namespace scree::scenario {

// Reads [[probe]]. A probe may read columns of others that stand before or behind it.
std::vector<ProbePlan> read_probes(const document::Table& root, const Scene& scene,
                                   const std::vector<Stage>& stages, PluginHost& host);

ProbeColumns columns_of(const ProbePlan& probe, int dimension);

}  // namespace scree::scenario
