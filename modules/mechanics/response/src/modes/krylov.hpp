#pragma once

#include <functional>

#include <Eigen/Core>

namespace scree::response {

using Operator = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

struct KrylovOptions {
  Eigen::Index wanted;
  bool both_ends = false;    // true: eigenvalues of largest magnitude; false: the largest
  double tolerance = 1e-11;  // largest |A x − θ x|/|θ|
  std::function<bool()> proceed = [] { return true; };
  std::function<void(Eigen::Index converged)> on_step = [](Eigen::Index) {};
};

// Orthonormal vectors by columns, and their eigenvalues, in the wanted order.
struct KrylovResult {
  Eigen::MatrixXd vectors;
  Eigen::VectorXd values;
};

// Finds eigenvectors of a symmetric operator by block Lanczos iteration with full orthogonalisation and thick
// restarts. Returns the converged ones: fewer than wanted if the iteration stops, or if the start reaches no
// others.
KrylovResult krylov(const Operator& a, const Eigen::MatrixXd& start, const KrylovOptions& options);

}  // namespace scree::response
