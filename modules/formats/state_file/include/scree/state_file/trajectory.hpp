#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include <scree/state.hpp>

namespace scree::state_file {

// Bodies at one time. The kinds, numbers and shapes of arrays are the same in all frames of a file.
struct TrajectoryFrame {
  double time = 0;  // (s)
  std::uint64_t step = 0;
  int dimension = 3;               // 2 or 3
  std::array<bool, 3> periodic{};  // axes
  std::array<double, 3> edges{};   // (m) periods; 0 along other axes
  std::map<std::string, StateArray>
      fixed;  // one row for each body, of the first frame: "id", "species", "mass", "radius"
  std::map<std::string, StateArray> moving;  // the same of each frame: "position", "velocity", ...
};

// Adds a frame to an H5MD file (https://www.nongnu.org/h5md/h5md.html, 1.1) that has so many, or makes the
// file if it has none. The file is closed between frames, so that other programs can read it. Its layout
// follows from its frames: the same frames give the same bytes. `position` has no attribute "unit", since
// MDAnalysis 2 refuses lengths in m; it has a label instead. Not thread-safe, as the following. Throws Error
// (failure) "path: what is wrong; what to do".
void append_frame(const std::filesystem::path& path, const TrajectoryFrame& frame, std::uint64_t frames);

// Throws Error "path: what is wrong; what to do" if the file has not so many frames or cannot be read.
void check_frames(const std::filesystem::path& path, std::uint64_t frames);

// Replaces the file by one of its first frames, 1 or more, as if no other had been added. It stays whole
// until then. Throws as the others.
void cut_frames(const std::filesystem::path& path, std::uint64_t frames);

}  // namespace scree::state_file
