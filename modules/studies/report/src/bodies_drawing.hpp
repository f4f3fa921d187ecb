#pragma once

#include <filesystem>
#include <string>

namespace scree::report {

// The bodies of a packing from the side, for a run without pictures: as SVG with a scale, those behind paler,
// a colour for each material. Empty if there are none, or more than about 2000.
std::string bodies_drawing(const std::filesystem::path& packing);

}  // namespace scree::report
