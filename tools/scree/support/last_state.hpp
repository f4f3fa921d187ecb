#pragma once

#include <filesystem>
#include <optional>

namespace scree::tool {

// The last state of a run; none if it has none.
std::optional<std::filesystem::path> last_state(const std::filesystem::path& run);

// The file of a state: the source itself, or the last state of a run. Throws Error if the run has none.
std::filesystem::path state_of(const std::filesystem::path& source);

}  // namespace scree::tool
