#pragma once

#include <vector>

#include <scree/scenario/document_table.hpp>
#include <scree/scene.hpp>
#include <scree/stage.hpp>

namespace scree::scenario {

// The [[stage]]s, or the one stage that [time] duration stands for. `instances` are all named plug-ins with their
// first parameters; what a stage changes stays changed in the stages after it.
std::vector<Stage> read_stages(const Table& root, const Scene& scene, std::vector<Stage::Change> instances);

}  // namespace scree::scenario
