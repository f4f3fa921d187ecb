#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace scree {

// Components of the motion of a body, and of its load: translations along x, y and z, then rotations about
// them. A mask has the bit 1 << k for the component k.
namespace freedom {
inline constexpr int count = 6, first_rotation = 3;
using Mask = std::uint8_t;
inline constexpr Mask all = (1u << count) - 1, rotations = all & ~((1u << first_rotation) - 1);
constexpr bool is_in(Mask mask, int k) { return (mask >> k & 1u) != 0; }
// Those of a body: in 2D two translations and the rotation about z.
constexpr Mask of_dimension(int dimension) { return dimension == 2 ? 0b100011 : all; }
}  // namespace freedom

// Bodies that are moved, or on which a further load acts, as functions of time.
struct BodyGroup {
  // For each component the numbers of a Program (see program.hpp); empty: none.
  using Programs = std::array<std::vector<double>, freedom::count>;

  std::string name;
  std::vector<std::uint32_t> bodies;  // indices
  // Of components in which the bodies are held: (m/s), (rad/s), or (m), (rad), of which only increments
  // count.
  Programs velocity, displacement;
  Programs load;  // (N), (N m) on each body
};

// Bodies by name, which probes count or leave out.
struct BodySelection {
  std::string name;
  std::vector<std::uint32_t> bodies;  // indices
};

inline bool any_given(const BodyGroup::Programs& programs) {
  for (const std::vector<double>& program : programs)
    if (!program.empty()) return true;
  return false;
}

}  // namespace scree
