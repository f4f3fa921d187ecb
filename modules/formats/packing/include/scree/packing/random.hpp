#pragma once

#include <array>
#include <cstdint>

#include <scree/plugin/vec.hpp>

namespace scree::packing {

// xoshiro256++ generator (Blackman & Vigna 2021), seeded with splitmix64.
// Uses only integer operations, + - * / and sqrt, so a seed gives the same bits on every platform.
class Random {
 public:
  explicit Random(std::uint64_t seed);
  // Continues from a saved state, which must have a non-zero word.
  explicit Random(const std::array<std::uint64_t, 4>& state) : state_(state) {}

  const std::array<std::uint64_t, 4>& state() const { return state_; }

  // 64 random bits.
  std::uint64_t bits();
  // Uniform in [0, 1), a multiple of 2^-53.
  double uniform();
  // Uniform in [minimum, maximum].
  double uniform(double minimum, double maximum);
  // Normal with mean 0 and standard deviation 1.
  double normal();
  // Uniform in a ball (dimension 3) or disc (dimension 2, z = 0) of this radius about the origin.
  Vec3 in_ball(double radius, int dimension);

 private:
  std::array<std::uint64_t, 4> state_;
};

}  // namespace scree::packing
