#pragma once

#include <filesystem>

#include <scree/state.hpp>

namespace scree::state_file {

// Writes a state as an HDF5 file: the bodies as H5MD 1.1 under /particles/bodies, the other arrays by their
// paths under /scree, sealed with size and checksum. Equal states give equal bytes. The file gets its name
// when it is complete and on the disk; an earlier one stays whole until then. Not thread-safe. Throws Error
// (failure) "path: what is wrong; what to do", and std::invalid_argument for a state that breaks the rules of
// State.
void write_state(const std::filesystem::path& path, const State& state);

// Reads back exactly the state that was written. Size and checksum are compared before anything is
// interpreted. Not thread-safe. Throws Error "path: what is wrong; what to do".
State read_state(const std::filesystem::path& path);

}  // namespace scree::state_file
