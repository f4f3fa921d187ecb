#pragma once

#include "instances.hpp"

#include <vector>

#include <scree/document/table.hpp>
#include <scree/scenario/study_table.hpp>
#include <scree/scenario/table_keys.hpp>

namespace scree::scenario {

// Reads the [[stage]]s, or makes one stage of [time] duration. A change by a stage persists in the following
// stages. The scene must be complete except for what depends on the stages. There may be none with the table of a study;
// without `studies`, the scenario has been checked before and there may be none in any case.
std::vector<Stage> read_stages(const document::Table& root, const Scene& scene, Instances instances,
                               const StudyTables* studies, std::vector<std::string>& warnings);

// Reads a time (s). Throws Error unless it takes at least one step and at most 1e12.
double read_steps(const document::Table& table, const Key& key, double step);

}  // namespace scree::scenario
