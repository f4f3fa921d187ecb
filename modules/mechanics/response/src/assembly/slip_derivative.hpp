#pragma once

#include <Eigen/Core>

namespace scree::response {

// How the tangential increment of a pair changes with the end of a motion. (3, 3), by the displacement of a relative to b, and by the rotations of
// both.
struct SlipDerivative {
  Eigen::Matrix3d by_displacement, by_rotation_a, by_rotation_b;
};

}  // namespace scree::response
