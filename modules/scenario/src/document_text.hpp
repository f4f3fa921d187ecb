#pragma once

#include "document_node.hpp"

#include <string>

namespace scree::scenario {

// A tree as TOML text, keys in the order of the tree.
std::string toml_text(const Node& root);

}  // namespace scree::scenario
