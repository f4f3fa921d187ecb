#pragma once

#include "document_node.hpp"

#include <memory>
#include <string_view>

namespace scree::document {

// TOML text to nodes. Throws Error "name:line:column: not valid TOML: what; cure".
std::unique_ptr<Node> parse_toml(std::string_view text, std::string_view name);

// Whether TOML allows these characters, control characters aside.
bool is_toml_text(std::string_view text);

// The value of an override, marked with its number. A text that is no TOML value is a string, unless it opens
// with a bracket, brace or quote. Throws Error "place: not valid TOML: what; cure".
std::unique_ptr<Node> parse_override_value(std::string_view text, std::size_t number, std::string_view place);

}  // namespace scree::document
