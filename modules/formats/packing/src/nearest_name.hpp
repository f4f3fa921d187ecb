#pragma once

#include <span>
#include <string>
#include <string_view>

namespace scree::packing {

// Hint for an unknown name: the nearest known name, or all known names if none is near.
std::string suggest_name(std::string_view unknown, std::span<const std::string_view> known);

}  // namespace scree::packing
