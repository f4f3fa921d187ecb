#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace scree::pictures {

// (m) Ends along each axis; absent: none. What lies between them is drawn.
using Cut = std::array<std::optional<std::array<double, 2>>, 3>;

// Whether a part of a sphere (m) lies between the ends along each axis, or may, where two ends cut it.
inline bool reaches_into(const Cut& cut, const double* centre, double radius) {
  for (std::size_t k = 0; k < 3; ++k)
    if (cut[k] && !(centre[k] + radius > (*cut[k])[0] && centre[k] - radius < (*cut[k])[1])) return false;
  return true;
}

}  // namespace scree::pictures
