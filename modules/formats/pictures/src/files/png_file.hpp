#pragma once

#include <filesystem>

#include <scree/pictures/picture.hpp>

namespace scree::pictures {

// Both throw scree::Error.
void write_png(const Picture& picture, const std::filesystem::path& file);
Picture read_png(const std::filesystem::path& file);

}  // namespace scree::pictures
