#pragma once

#include <functional>

#include <Eigen/Core>

namespace scree::response {

using Operator = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

struct KrylovOptions {
  Eigen::Index wanted;
  bool both_ends = false;    // eigenvalues of largest magnitude; else the largest
  double tolerance = 1e-11;  // of |A x − θ x| over |θ|
  std::function<bool()> proceed = [] { return true; };
  std::function<void(Eigen::Index converged)> on_step = [](Eigen::Index) {};
};

// Orthonormal vectors by columns, and their eigenvalues, in the order wanted.
struct KrylovResult {
  Eigen::MatrixXd vectors;
  Eigen::VectorXd values;
};

// Eigenvectors of a symmetric operator by block Lanczos iteration with full orthogonalisation and thick restarts, those
// that converge. Fewer than wanted where the iteration stops, or where the start reaches no others.
KrylovResult krylov(const Operator& a, const Eigen::MatrixXd& start, const KrylovOptions& options);

}  // namespace scree::response
