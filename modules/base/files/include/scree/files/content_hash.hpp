#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace scree::files {

// Hash of a content (64 bits), as 16 hexadecimal digits.
std::string text_hash(std::string_view text);

// The same of what a file contains. A file is read once per process, until it is written or replaced. Empty
// if there is no such file or it cannot be read. Not thread-safe.
std::string file_hash(const std::filesystem::path& path);

}  // namespace scree::files
