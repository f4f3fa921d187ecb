#include "band/backend/inertia.hpp"

#include <algorithm>

#include <Eigen/Eigenvalues>

namespace scree::response {

namespace {

constexpr Eigen::Index block = 48;
// Smallest eigenvalue of a block over the largest entry of the matrix with which round-off grows little in the rest.
constexpr double least_pivot = 1e-4;

int below_zero(const Eigen::VectorXd& values) { return int((values.array() < 0).count()); }

}  // namespace

int negative_eigenvalues(Eigen::MatrixXd matrix) {
  using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;
  int negative = 0;
  while (matrix.rows() > 0) {
    const Eigen::Index width = std::min(block, matrix.rows()), rest = matrix.rows() - width;
    const Solver head(matrix.topLeftCorner(width, width));
    const double smallest = head.eigenvalues().cwiseAbs().minCoeff();
    if (rest > 0 && !(smallest > least_pivot * matrix.cwiseAbs().maxCoeff()))
      return negative + below_zero(Solver(matrix, Eigen::EigenvaluesOnly).eigenvalues());
    negative += below_zero(head.eigenvalues());
    const Eigen::MatrixXd coupling = matrix.bottomLeftCorner(rest, width) * head.eigenvectors();
    const Eigen::MatrixXd scaled = coupling * head.eigenvalues().cwiseInverse().asDiagonal();
    Eigen::MatrixXd next = matrix.bottomRightCorner(rest, rest);
    next.noalias() -= scaled * coupling.transpose();
    matrix = std::move(next);
  }
  return negative;
}

}  // namespace scree::response
