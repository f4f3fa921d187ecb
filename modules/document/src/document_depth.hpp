#pragma once

#include "document_node.hpp"

#include <optional>
#include <string_view>

namespace scree::document {

// Deepest nesting of tables and arrays that a document may have.
inline constexpr int deepest_nesting = 64;

// Where a dotted key has far too many parts. The TOML parser nests one table for each and would leave the
// stack.
std::optional<Place> find_endless_key(std::string_view text);

}  // namespace scree::document
