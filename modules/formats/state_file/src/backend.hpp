#pragma once

#include "placed_array.hpp"

#include <filesystem>
#include <vector>

#include <scree/state.hpp>
#include <scree/state_file/trajectory.hpp>

namespace scree::state_file {

// Incremented when this interface or a struct in it changes; loader and library must have the same version.
inline constexpr int backend_version = 3;

// Reads and writes what follows the seal of a state file: HDF5. Every function throws Error with what
// is wrong, without path and cure.
class StateBackend {
 public:
  virtual ~StateBackend() = default;

  // Replaces the content of a file by room for the seal and the state.
  virtual void write(const std::filesystem::path& file, const State& state) = 0;

  // The arrays of a file and where they lie in it. Some files crash HDF5 here, or keep it busy for ever.
  virtual std::vector<PlacedArray> places(const std::filesystem::path& file) = 0;

  // As append_frame() and check_frames() of trajectory.hpp, and the frame of this number.
  virtual void append_frame(const std::filesystem::path& file, const TrajectoryFrame& frame,
                            std::uint64_t frames) = 0;
  virtual void check_frames(const std::filesystem::path& file, std::uint64_t frames) = 0;
  virtual TrajectoryFrame frame(const std::filesystem::path& file, std::uint64_t number) = 0;
};

// Loads libscree_state_hdf5.so, and with it HDF5, once. file: the state for which it is needed, for messages.
// Throws Error if the library is missing, broken or outdated, or memory is short.
StateBackend& load_backend(const std::filesystem::path& file);

}  // namespace scree::state_file
