#pragma once

#include <filesystem>

#include <scree/snapshot/picture.hpp>

namespace scree::snapshot {

// Both throw scree::Error.
void write_png(const Picture& picture, const std::filesystem::path& file);
Picture read_png(const std::filesystem::path& file);

}  // namespace scree::snapshot
