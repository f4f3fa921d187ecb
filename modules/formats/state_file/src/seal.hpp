#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace scree::state_file {

// The first bytes of a state file, a text before the HDF5 file: format, version, size and checksum.
struct Seal {
  static constexpr std::size_t size = 512;  // bytes; the smallest user block of HDF5
  static constexpr int newest = 2;          // format that is written
  static constexpr int oldest = 1;          // format that is read

  int format = newest;  // counts incompatible changes of the file
  std::string program_version;
  std::uint64_t bytes = 0;     // of the whole file
  std::uint64_t checksum = 0;  // of the whole file, with 0 for the checksum

  // The text, always `size` bytes.
  std::string text() const;
};

// Writes the seal of this program into the first bytes of an open file. Throws Error (failure).
void write_seal(int descriptor, const std::filesystem::path& path);

// Reads the seal and compares size, checksum and every byte of the seal. Throws Error with the path.
Seal checked_seal(int descriptor, const std::filesystem::path& path);

}  // namespace scree::state_file
