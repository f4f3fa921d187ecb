#pragma once

#include <filesystem>
#include <string>

namespace scree::files {

// The absolute path without symbolic links, as far as it exists. An empty path is the current folder.
std::filesystem::path resolved(const std::filesystem::path& path);

// The path relative to a folder, for a file in that folder: both can then be moved together.
std::string relative_to(const std::filesystem::path& folder, const std::filesystem::path& path);

}  // namespace scree::files
