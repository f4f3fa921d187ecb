#pragma once

#include "handle.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <scree/state.hpp>

namespace scree::state_file {

// Reads the elements of /particles/all that FileWriter has written, by their names there. Every function
// throws Error without path and cure.
class TrajectoryReader {
 public:
  explicit TrajectoryReader(const std::filesystem::path& file);

  // Elements that have a value at each time, but the box; and those that do not change.
  std::vector<std::string> moving() const { return elements(H5I_GROUP); }
  std::vector<std::string> fixed() const { return elements(H5I_DATASET); }
  bool has(const std::string& name) const;
  // Of the axes of the box.
  std::vector<std::string> boundary() const;

  // Throws Error if a dataset has fewer frames.
  void check(const std::string& name, std::uint64_t frames) const;
  // One frame of a dataset, or all of one without frames.
  StateArray array(const std::string& name, std::optional<std::uint64_t> frame) const;

 private:
  std::vector<std::string> elements(H5I_type_t type) const;

  Handle file_, all_;
};

}  // namespace scree::state_file
