#pragma once

#include <cstdint>

#include <scree/plugin/vec.hpp>

namespace scree::response {

// A pair of bodies, or of a body and a wall.
struct StaticPair {
  std::uint32_t a, b;  // as in ContactList
  Vec3 shift;          // (m) added to x_a − x_b of bodies, for the nearest images
};

}  // namespace scree::response
