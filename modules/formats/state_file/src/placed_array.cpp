#include "placed_array.hpp"

#include <cstring>
#include <stdexcept>

namespace scree::state_file {
namespace {

// Packer and Unpacker have the same functions, so that transfer() lists the members of an array for both.
struct Packer {
  std::string bytes;

  void number(const std::uint64_t& n) { bytes.append(reinterpret_cast<const char*>(&n), sizeof n); }
  void text(const std::string& t) { number(t.size()), bytes += t; }
  void numbers(const std::vector<std::uint64_t>& all) {
    number(all.size());
    for (const std::uint64_t n : all) number(n);
  }
};

struct Unpacker {
  std::string_view bytes;

  void require(std::uint64_t count) const {
    if (count > bytes.size()) throw std::length_error("a list of arrays ends early");
  }
  void number(std::uint64_t& n) {
    require(sizeof n);
    std::memcpy(&n, bytes.data(), sizeof n);
    bytes.remove_prefix(sizeof n);
  }
  void text(std::string& t) {
    std::uint64_t size = 0;
    number(size), require(size);
    t = bytes.substr(0, size);
    bytes.remove_prefix(size);
  }
  void numbers(std::vector<std::uint64_t>& all) {
    std::uint64_t count = 0;
    number(count), require(count);
    all.resize(count);
    for (std::uint64_t& n : all) number(n);
  }
};

template <class Packing, class Array>
void transfer(Packing& packing, Array& array) {
  packing.text(array.path), packing.number(array.kind), packing.text(array.unit);
  packing.numbers(array.shape);
  packing.number(array.offset), packing.number(array.width);
  packing.numbers(array.lengths);
  packing.text(array.dataset), packing.number(array.as_frame);
}

}  // namespace

std::string packed(const std::vector<PlacedArray>& arrays) {
  Packer packer;
  for (const PlacedArray& array : arrays) transfer(packer, array);
  return std::move(packer.bytes);
}

std::vector<PlacedArray> unpacked(std::string_view bytes) {
  std::vector<PlacedArray> arrays;
  for (Unpacker unpacker{bytes}; !unpacker.bytes.empty();) transfer(unpacker, arrays.emplace_back());
  return arrays;
}

}  // namespace scree::state_file
