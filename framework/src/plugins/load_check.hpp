#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace scree {

// Loads a library in a child process. Returns what it does to the program if its constructors, which run
// before the host can check anything, end that process or do not return. Nothing if the library can be loaded
// or is refused. longest: the time for which they are waited for (s).
std::optional<std::string> fatal_load(const std::filesystem::path& library, double longest = 10);

}  // namespace scree
