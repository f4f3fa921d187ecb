#pragma once

#include "placed_array.hpp"

#include <filesystem>

#include <scree/state.hpp>

namespace scree::state_file {

// Reads arrays from their places in a file. A damaged file may claim any places: before memory is allocated,
// each array and the sum of all are compared with the size of the file, and the memory with a limit. Throws
// Error without path and cure.
class ArrayReader {
 public:
  // file_bytes: size of the open file; memory: bytes that the arrays may take.
  ArrayReader(int descriptor, std::uint64_t file_bytes, double memory)
      : descriptor_(descriptor), file_bytes_(file_bytes), bytes_left_(file_bytes), memory_left_(memory) {}

  StateArray read(const PlacedArray& place);

 private:
  // Bytes of the values, after the comparisons.
  std::uint64_t bytes_of(const PlacedArray& place);
  void read_bytes(const PlacedArray& place, void* to, std::uint64_t bytes) const;
  template <class T>
  std::vector<T> values(const PlacedArray& place, std::uint64_t bytes) const;

  int descriptor_;
  std::uint64_t file_bytes_;
  std::uint64_t bytes_left_;  // of the file, for further arrays
  double memory_left_;
};

}  // namespace scree::state_file
