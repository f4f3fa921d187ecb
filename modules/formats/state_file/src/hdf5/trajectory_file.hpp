#pragma once

#include <cstdint>
#include <filesystem>

#include <scree/state_file/trajectory.hpp>

namespace scree::state_file {

// Frames in a file of H5MD 1.1, in the group /particles/all. All throw Error without path and cure.

// Adds frame number `frame` to a file that has those before it; number 0 replaces the content of the file.
void append_to_trajectory(const std::filesystem::path& file, const TrajectoryFrame& now, std::uint64_t frame);

// Throws Error unless every element has so many frames.
void check_trajectory(const std::filesystem::path& file, std::uint64_t frames);

TrajectoryFrame frame_of_trajectory(const std::filesystem::path& file, std::uint64_t frame);

}  // namespace scree::state_file
