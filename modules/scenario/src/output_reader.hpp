#pragma once

#include <vector>

#include <scree/document/table.hpp>
#include <scree/scenario/plan.hpp>

namespace scree::scenario {

// step: the time step (s), minimum of all intervals.
SnapshotPlan read_snapshot(const document::Table& root, double step);
// Reads expectations of a run and of peaks; the plan has its probes and its spectrum already.
void read_expectations(const document::Table& root, Plan& plan);

}  // namespace scree::scenario
