#include "plugins/enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

Vec3 enclosed_lengths(const std::vector<scree_plane>& planes, const Domain& domain, int dimension) {
  constexpr double infinite = std::numeric_limits<double>::infinity(), along = 0.999999;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Vec3 lengths = {{none, none, none}};
  for (int k = 0; k < dimension; ++k) {
    double low = -infinite, high = infinite;
    for (const scree_plane& plane : planes) {
      if (plane.normal[k] > along) low = std::max(low, plane.point[k]);
      if (plane.normal[k] < -along) high = std::min(high, plane.point[k]);
    }
    if (domain.periodic[std::size_t(k)])
      lengths[k] = domain.length(k);
    else if (std::isfinite(high - low))
      lengths[k] = high - low;
  }
  return lengths;
}

}  // namespace scree
