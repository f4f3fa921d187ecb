#pragma once

#include <Eigen/Core>

namespace scree::response {

// A pair that begins to touch within an increment: only the displacement since then moves its tangential spring.
struct Onset {
  double touched = 1;  // share of the increment
  Eigen::Vector3d slip =
      Eigen::Vector3d::Zero();  // (m) of the contact point in the whole increment, across the normal
  Eigen::Vector3d touched_by_displacement = Eigen::Vector3d::Zero();  // (1/m) of a relative to b

  bool within_increment() const { return touched < 1; }
};

}  // namespace scree::response
