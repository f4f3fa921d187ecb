#pragma once

#include <cstddef>
#include <cstdint>

namespace scree {

// 64-bit hash of the exact bits of a state: FNV-1a over 8-byte words. Equal states have equal hashes on every
// machine.
class StateHash {
 public:
  // Stored in a state whose numbers no simulation has hashed.
  static constexpr std::uint64_t unknown = 0;

  void add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x100000001b3u;
    value_ ^= value_ >> 32;
  }
  void add(double x) { add(__builtin_bit_cast(std::uint64_t, x)); }
  void add(const double* data, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) add(data[k]);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace scree
