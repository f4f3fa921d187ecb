#pragma once

#include "names.hpp"

#include <string>
#include <vector>

#include <scree/document/table.hpp>
#include <scree/plugin_host.hpp>
#include <scree/scene.hpp>
#include <scree/stage.hpp>

namespace scree::scenario {

// The laws, boundaries and body forces of a scene by the names that stages refer to, with their parameters.
struct Instances {
  std::vector<Stage::Change> all;
  UniqueNames names{"law, boundary or force"};
};

// Reads one entry of [[contact]], [[boundary]] or [[body_force]], tries it out and adds it to the instances.
// The scene must hold its bodies already. Throws Error at the key that is wrong.
const Stage::Change& read_instance(const document::Table& table, scree_kind kind, PluginHost& host,
                                   const Scene& scene, Instances& instances);

// An instance with the keys of `table` (what a stage sets) in the place of the old ones, tried out.
// Throws Error at the key that is wrong.
Stage::Change changed_instance(const document::Table& table, const Stage::Change& old, const Scene& scene);

}  // namespace scree::scenario
