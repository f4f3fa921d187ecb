#pragma once

#include <filesystem>
#include <string_view>

namespace scree::snapshot {

// Writes the bytes under a temporary name in the same directory, then renames: the file is there whole or not
// at all. Creates missing directories. Throws scree::Error.
void write_atomically(const std::filesystem::path& file, std::string_view bytes);

}  // namespace scree::snapshot
