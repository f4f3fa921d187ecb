#include "walls/enclosure.hpp"

#include <limits>

#include <scree/plugin/walls.hpp>

namespace scree {

Vec3 enclosed_lengths(const Boundaries& boundaries, int dimension) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const Domain& domain = boundaries.domain();
  const auto height = [&](int axis, int sign) {
    return wall_height(boundaries.planes(), axis, sign, boundaries.absent().data());
  };
  Vec3 lengths = {{none, none, none}};
  for (int k = 0; k < dimension; ++k)
    lengths[k] = domain.periodic[std::size_t(k)] ? domain.length(k) : height(k, -1) - height(k, 1);
  return lengths;
}

}  // namespace scree
