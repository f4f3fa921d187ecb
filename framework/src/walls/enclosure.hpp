#pragma once

#include "walls/boundaries.hpp"

namespace scree {

// Lengths of a scene along each axis (m): the period, or the distance of the two opposite walls that are
// normal to the axis and nearest to the bodies; absent walls count only where there are no others. NaN along
// an axis that is not enclosed.
Vec3 enclosed_lengths(const Boundaries& boundaries, int dimension);

}  // namespace scree
