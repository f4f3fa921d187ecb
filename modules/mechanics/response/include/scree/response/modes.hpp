#pragma once

#include <Eigen/Core>

#include <scree/response/linear_system.hpp>

namespace scree::response {

// Free motions without damping, q = shape cos(ωt): as many as there are masses above 0. Walls without mass follow
// the others at once.
struct Modes {
  Eigen::VectorXd square_frequency;  // ω² (1/s²), ascending; below 0: the packing is unstable
  Eigen::MatrixXd shape;             // one column each, normalised to shapeᵀ M shape = 1
  // |K − Kᵀ|/|K| in mass-weighted coordinates √M q. Modes are those of the symmetric part of K.
  double asymmetry;
};

// All modes by a dense solver; for systems of up to some thousand degrees of freedom.
Modes modes_of(const LinearSystem& system);

}  // namespace scree::response
