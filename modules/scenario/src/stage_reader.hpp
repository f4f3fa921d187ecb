#pragma once

#include "instances.hpp"

#include <vector>

#include <scree/document/table.hpp>

namespace scree::scenario {

// The [[stage]]s, or the one stage that [time] duration stands for. What a stage changes of an instance stays
// changed in the stages after it. The scene must be complete but for what comes with the stages.
std::vector<Stage> read_stages(const document::Table& root, const Scene& scene, Instances instances);

// The time (s) under a key. Throws Error unless it takes at least one step, and less than a lifetime.
double read_steps(const document::Table& table, std::string_view key, double step);

}  // namespace scree::scenario
