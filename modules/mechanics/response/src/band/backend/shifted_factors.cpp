#include "band/backend/shifted_factors.hpp"

#include "band/backend/inertia.hpp"
#include "band/backend/symmetric_factors.hpp"

namespace scree::response {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

class Factors : public ShiftedFactors {
 public:
  Factors(const Elimination& plan, const Sparse& a)
      : factors_(plan, a, nullptr,
                 [this](const Eigen::MatrixXd& pivot) { negative_ += negative_eigenvalues(pivot); }) {}

  void solve(double* x, int columns) const override {
    Eigen::Map<Eigen::MatrixXd> all(x, factors_.size(), columns);
    all = factors_.solve(all);
  }
  int negative() const override { return negative_; }

 private:
  int negative_ = 0;
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
    return std::make_unique<Factors>(plan_, Sparse(stiffness_ - shift * mass_));
  }

 private:
  Sparse mass_, stiffness_;
  Elimination plan_;
};

}  // namespace

std::unique_ptr<ShiftBackend> make_shifts(const SparseView& stiffness, const double* mass) {
  return std::make_unique<Shifts>(stiffness, mass);
}

}  // namespace scree::response
