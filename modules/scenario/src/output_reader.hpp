#pragma once

#include <vector>

#include <scree/document/table.hpp>
#include <scree/scenario/plan.hpp>

namespace scree::scenario {

// step: the time step (s), minimum of all intervals.
SnapshotPlan read_snapshot(const document::Table& root, double step);
// Sorts [[expect]] into those of the run and of studies; the plan has its probes already. studies: as for read_stages.
void read_expectations(const document::Table& root, const StudyTables* studies, Plan& plan);

}  // namespace scree::scenario
