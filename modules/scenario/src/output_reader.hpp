#pragma once

#include <vector>

#include <scree/scenario/document_table.hpp>
#include <scree/scenario/plan.hpp>

namespace scree::scenario {

std::vector<ProbePlan> read_probes(const Table& root, const Scene& scene, const std::vector<Stage>& stages,
                                   PluginHost& host);
// step: the time step (s), below which nothing can be written.
SnapshotPlan read_snapshot(const Table& root, double step);
std::vector<ChartPlan> read_charts(const Table& root, const std::vector<ProbePlan>& probes, int dimension);
std::vector<Expectation> read_expectations(const Table& root, const std::vector<ProbePlan>& probes,
                                           int dimension);

}  // namespace scree::scenario
