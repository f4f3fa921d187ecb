#pragma once

#include "instances.hpp"

namespace scree::scenario {

// Reads the [[contact]] laws and assigns one to each pair of materials. The scene must have its materials.
void read_contacts(const document::Table& root, PluginHost& host, Scene& scene, Instances& instances);

}  // namespace scree::scenario
