#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace scree::document {

// The text of a file of at most largest bytes. Throws Error "path: cannot be read (reason); what to do".
std::string read_text_file(const std::filesystem::path& path, std::size_t largest);

}  // namespace scree::document
