#pragma once

#include <filesystem>
#include <string>

namespace scree::state_file {

// Lines that say what a state file is: who wrote it, time, bodies, and all arrays by the paths of their
// datasets in HDF5, with type, shape, unit and bytes, and notes on those of contacts. Throws Error like
// read_state.
std::string describe_state_file(const std::filesystem::path& path);

}  // namespace scree::state_file
