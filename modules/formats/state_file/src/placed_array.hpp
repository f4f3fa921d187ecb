#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scree::state_file {

// An array of a state file and where its bytes lie, in one piece and with the lowest byte of a number first.
struct PlacedArray {
  std::string path;
  std::uint64_t kind = 0;  // place of its type in StateArray::values
  std::string unit;
  std::vector<std::uint64_t> shape;
  std::uint64_t offset = 0;            // (bytes) from the start of the file
  std::uint64_t width = 0;             // bytes of a value
  std::vector<std::uint64_t> lengths;  // bytes of each text; empty: up to the zeros with which it is filled
  std::string dataset = {};            // its path in the file, which other programs know
  std::uint64_t as_frame = 0;          // 1 if the dataset has a leading dimension of 1, the time

  bool operator==(const PlacedArray&) const = default;
};

// Arrays as bytes for another process, and back. unpacked() throws std::length_error for other bytes.
std::string packed(const std::vector<PlacedArray>& arrays);
std::vector<PlacedArray> unpacked(std::string_view bytes);

}  // namespace scree::state_file
