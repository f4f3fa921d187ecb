#pragma once

#include <filesystem>
#include <string>

namespace scree::tool {

// Absolute and without symbolic links, as far as it exists.
std::filesystem::path resolved(const std::filesystem::path& path);

// A path as a file in the folder names it, so that both can be moved together.
std::string relative_to(const std::filesystem::path& folder, const std::filesystem::path& path);

}  // namespace scree::tool
