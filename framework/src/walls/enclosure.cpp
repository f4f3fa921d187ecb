#include "walls/enclosure.hpp"

#include <limits>

#include <scree/plugin/walls.hpp>

namespace scree {

Vec3 enclosed_lengths(const std::vector<scree_plane>& planes, const Domain& domain, int dimension) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Vec3 lengths = {{none, none, none}};
  for (int k = 0; k < dimension; ++k)
    lengths[k] = domain.periodic[std::size_t(k)] ? domain.length(k)
                                                 : wall_height(planes, k, -1) - wall_height(planes, k, 1);
  return lengths;
}

}  // namespace scree
