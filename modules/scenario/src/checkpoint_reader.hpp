#pragma once

#include <scree/document/table.hpp>
#include <scree/scenario/plan.hpp>

namespace scree::scenario {

CheckpointPlan read_checkpoint(const document::Table& root, double step);

}  // namespace scree::scenario
