#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace scree::packing {

// Contents of a regular, uncompressed file. Throws Error if it cannot be read or does not fit into memory.
std::string read_text(const std::filesystem::path& path);

// Writes the file, replacing an existing one. Throws Error if it cannot be written.
void write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace scree::packing
