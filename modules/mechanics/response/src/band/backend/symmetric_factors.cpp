#include "band/backend/symmetric_factors.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

namespace scree::response {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

// Columns of a matrix that are reduced at once, by their eigenvalues.
constexpr Eigen::Index block = 48;
// Smallest eigenvalue of a block over the largest entry of the matrix with which round-off grows little in
// the rest.
constexpr double least_pivot = 1e-4;
constexpr double round_off = std::numeric_limits<double>::epsilon();

int below_zero(const Eigen::VectorXd& values) { return int((values.array() < 0).count()); }

class Factors : public ShiftedFactors {
 public:
  Factors(const Elimination& plan, const Sparse& a, double shift)
      : shift_(shift), factors_(plan, a, nullptr, [this](const Eigen::MatrixXd& pivot, double largest_term) {
          add(pivot, largest_term);
        }) {}

  void solve(double* x, int columns) const override {
    Eigen::Map<Eigen::MatrixXd> all(x, factors_.size(), columns);
    all = factors_.solve(all);
  }
  double shift() const override { return shift_; }
  int negative() const override { return negative_; }
  double margin() const override { return std::max(margin_, round_off * factors_.largest_term()); }
  bool has_null_pivot() const override { return null_pivot_; }

 private:
  // Round-off of an eigenvalue of a block: that of its entries, as random errors of all rows add up.
  void add(const Eigen::MatrixXd& pivot, double largest_term) {
    const PivotSigns signs = signs_of(pivot);
    const double error =
        round_off * std::sqrt(double(pivot.rows())) * std::max(largest_term, signs.largest_term);
    negative_ += signs.negative;
    margin_ = std::max(margin_, error);
    null_pivot_ |= !(signs.smallest > error);
  }

  double shift_;
  int negative_ = 0;
  double margin_ = 0;
  bool null_pivot_ = false;
  SymmetricFactors<double> factors_;
};

class Shifts : public ShiftBackend {
 public:
  Shifts(const SparseView& stiffness, const double* mass)
      : mass_(stiffness.size, stiffness.size),
        stiffness_(copy_of(stiffness)),
        plan_(plan_elimination(stiffness_)) {
    mass_.setIdentity();
    mass_ = Sparse(Eigen::Map<const Eigen::VectorXd>(mass, stiffness.size).asDiagonal() * mass_);
  }

  std::unique_ptr<ShiftedFactors> factorise(double shift) const override {
    return std::make_unique<Factors>(plan_, Sparse(stiffness_ - shift * mass_), shift);
  }

 private:
  Sparse mass_, stiffness_;
  Elimination plan_;
};

}  // namespace

PivotSigns signs_of(Eigen::MatrixXd matrix) {
  using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;
  PivotSigns signs = {.smallest = std::numeric_limits<double>::infinity(),
                      .largest_term = matrix.cwiseAbs().maxCoeff()};
  const auto add = [&signs](const Eigen::VectorXd& values) {
    signs.negative += below_zero(values);
    signs.smallest = std::min(signs.smallest, values.cwiseAbs().minCoeff());
  };
  while (matrix.rows() > 0) {
    const Eigen::Index width = std::min(block, matrix.rows()), rest = matrix.rows() - width;
    const Solver head(matrix.topLeftCorner(width, width));
    const double smallest = head.eigenvalues().cwiseAbs().minCoeff();
    if (rest > 0 && !(smallest > least_pivot * matrix.cwiseAbs().maxCoeff())) {
      add(Solver(matrix, Eigen::EigenvaluesOnly).eigenvalues());
      return signs;
    }
    add(head.eigenvalues());
    if (rest == 0) break;
    const Eigen::MatrixXd coupling = matrix.bottomLeftCorner(rest, width) * head.eigenvectors();
    const Eigen::MatrixXd scaled = coupling * head.eigenvalues().cwiseInverse().asDiagonal();
    Eigen::MatrixXd next = matrix.bottomRightCorner(rest, rest);
    next.noalias() -= scaled * coupling.transpose();
    matrix = std::move(next);
    signs.largest_term = std::max(signs.largest_term, matrix.cwiseAbs().maxCoeff());
  }
  return signs;
}

std::unique_ptr<ShiftBackend> make_shifts(const SparseView& stiffness, const double* mass) {
  return std::make_unique<Shifts>(stiffness, mass);
}

}  // namespace scree::response
