#pragma once

#include "instances.hpp"

namespace scree::scenario {

// The [[contact]] laws, and which of them each pair of materials follows. The scene must hold its materials.
void read_contacts(const document::Table& root, PluginHost& host, Scene& scene, Instances& instances);

}  // namespace scree::scenario
