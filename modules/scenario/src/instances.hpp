#pragma once

#include <string>
#include <vector>

#include <scree/document/table.hpp>
#include <scree/plugin_host.hpp>
#include <scree/scenario/names.hpp>
#include <scree/scene.hpp>
#include <scree/stage.hpp>

namespace scree::scenario {

// Laws, boundaries and body forces of a scene with their parameters, by the names used in stages.
struct Instances {
  std::vector<Stage::Change> all;
  UniqueNames names{"law, boundary or force"};
};

// Reads one entry of [[contact]], [[boundary]] or [[body_force]], checks it and adds it to the instances.
// The scene must have its bodies already. Throws Error at the wrong key.
const Stage::Change& read_instance(const document::Table& table, scree_kind kind, PluginHost& host,
                                   const Scene& scene, Instances& instances);

// The instance with the parameters in `table` (of a stage) replaced, checked. Throws Error at a wrong key.
Stage::Change changed_instance(const document::Table& table, const Stage::Change& old, const Scene& scene);

}  // namespace scree::scenario
