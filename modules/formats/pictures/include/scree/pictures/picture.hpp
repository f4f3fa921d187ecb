#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace scree::pictures {

// Pixels of an image, rows from top to bottom.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  // (3 width height)

  std::array<std::uint8_t, 3> at(int x, int y_from_top) const {
    const std::size_t first = 3 * (std::size_t(y_from_top) * width + x);
    return {rgb[first], rgb[first + 1], rgb[first + 2]};
  }
};

}  // namespace scree::pictures
