#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace scree {

// Loads a library in a child process. Returns how that process ended if the library ended it: its
// constructors run before the host can check anything. Nothing if the library can be loaded or is refused.
std::optional<std::string> fatal_load(const std::filesystem::path& library);

}  // namespace scree
