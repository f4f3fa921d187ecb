#pragma once

#include <Eigen/Core>

namespace scree::response {

// Number of eigenvalues below 0 of a symmetric matrix.
int negative_eigenvalues(Eigen::MatrixXd matrix);

}  // namespace scree::response
