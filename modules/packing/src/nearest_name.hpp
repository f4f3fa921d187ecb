#pragma once

#include <span>
#include <string>
#include <string_view>

namespace scree::packing {

// Cure for an unknown name: the known name with the fewest letters to change, or, if none is near, all of
// them.
std::string suggest_name(std::string_view unknown, std::span<const std::string_view> known);

}  // namespace scree::packing
