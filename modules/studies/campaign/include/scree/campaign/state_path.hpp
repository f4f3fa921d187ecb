#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace scree::campaign {

// Puts a folder before those in the environment variable SCREE_STATE_PATH, for this process and those that it starts,
// until the end of this object. Not thread-safe.
class StatePath {
 public:
  // Throws Error if the path contains ':', which separates folders.
  explicit StatePath(const std::filesystem::path& folder);
  ~StatePath();
  StatePath(const StatePath&) = delete;
  StatePath& operator=(const StatePath&) = delete;

 private:
  std::optional<std::string> before_;
};

}  // namespace scree::campaign
