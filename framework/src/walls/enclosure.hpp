#pragma once

#include <vector>

#include <scree/domain.hpp>
#include <scree/plugin/abi.h>

namespace scree {

// Lengths of a scene along each axis (m): the period, or the distance of the two opposite walls that are normal
// to the axis and nearest to the bodies. NaN along an axis that is not enclosed.
Vec3 enclosed_lengths(const std::vector<scree_plane>& planes, const Domain& domain, int dimension);

}  // namespace scree
