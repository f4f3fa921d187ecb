#pragma once

#include "instances.hpp"
#include "table_keys.hpp"

#include <vector>

#include <scree/document/table.hpp>

namespace scree::scenario {

// Of a stage, or of one frequency of a sweep. At one microsecond per step, faster than almost any scene, this takes twelve days.
inline constexpr double most_steps = 1e12;

// Reads the [[stage]]s, or makes one stage of [time] duration. A change by a stage persists in the following
// stages. The scene must be complete except for what depends on the stages.
std::vector<Stage> read_stages(const document::Table& root, const Scene& scene, Instances instances,
                               std::vector<std::string>& warnings);

// Reads a time (s). Throws Error unless it takes at least one step and at most 1e12.
double read_steps(const document::Table& table, const Key& key, double step);

}  // namespace scree::scenario
