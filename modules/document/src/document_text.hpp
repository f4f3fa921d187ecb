#pragma once

#include "document_node.hpp"

#include <string>

namespace scree::document {

// A tree as TOML text, keys in the order of the tree.
std::string toml_text(const Node& root);

// One value as TOML in one line.
std::string value_text(const Node& node);

}  // namespace scree::document
