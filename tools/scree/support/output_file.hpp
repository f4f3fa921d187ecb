#pragma once

#include <filesystem>
#include <string>

namespace scree::tool {

// Before a long computation: throws Error if the file of an option, such as --out, has no folder, is not a
// regular file, or is there and may not be replaced.
void check_output_file(const std::string& option, const std::filesystem::path& file, bool overwrite);

}  // namespace scree::tool
