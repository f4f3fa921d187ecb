#pragma once

#include <filesystem>
#include <string_view>

namespace scree::pictures {

// Writes the bytes to a temporary file in the same directory and renames it, so the file is never incomplete.
// Creates its directory, but none above. Throws scree::Error.
void write_atomically(const std::filesystem::path& file, std::string_view bytes);

}  // namespace scree::pictures
