#pragma once

#include <string>
#include <string_view>

namespace scree::document {

// The complaint of the TOML parser as one line "not valid TOML: what; cure".
std::string syntax_complaint(std::string_view description);

}  // namespace scree::document
