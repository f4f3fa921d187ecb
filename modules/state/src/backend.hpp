#pragma once

#include <filesystem>

#include <scree/state.hpp>

namespace scree::state_file {

// Incremented when this interface or a struct in it changes; loader and library must have the same version.
inline constexpr int backend_version = 1;

// Reads and writes what stands behind the seal of a state file: HDF5. Every function throws Error with what is
// wrong, without path and cure.
class StateBackend {
 public:
  virtual ~StateBackend() = default;

  // Replaces the content of a file by the state, behind room for the seal.
  virtual void write(const std::filesystem::path& file, const State& state) = 0;

  // `largest`: bytes of memory that the arrays may take.
  virtual State read(const std::filesystem::path& file, double largest) = 0;
};

// Loads libscree_state_hdf5.so, and with it HDF5, once. Throws Error if it is missing, broken or outdated.
StateBackend& load_backend();

}  // namespace scree::state_file
