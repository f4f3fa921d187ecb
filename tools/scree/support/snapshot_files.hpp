#pragma once

#include <filesystem>
#include <vector>

namespace scree::tool {

// The particle files of a run directory or of its snapshots folder in order of time, or the one file named.
// Throws Error if there is none.
std::vector<std::filesystem::path> snapshot_files(const std::filesystem::path& source);
// Whether a path is that of a folder; not where it cannot be asked.
bool is_folder(const std::filesystem::path& path);
bool has_snapshots(const std::filesystem::path& run);

}  // namespace scree::tool
