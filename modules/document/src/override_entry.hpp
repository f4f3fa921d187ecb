#pragma once

#include "document_node.hpp"

#include <cstddef>
#include <string_view>

namespace scree::document {

// Entries of arrays as overrides address them. Errors list the entries with their indices.

// The entry whose name, or else plugin, or else type is this; null when none is. Throws when several are.
Node* named_entry(const Node& array, std::string_view name, std::string_view place);

// The one entry of an array of tables; throws when there are several. key is what is looked for in it.
Node& only_entry(const Node& array, std::string_view key, std::string_view place);

// Element by index; index 0 of a table is the table itself.
Node& entry_at(Node& node, std::size_t index, std::string_view place);

}  // namespace scree::document
