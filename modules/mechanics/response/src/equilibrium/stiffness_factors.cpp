#include "equilibrium/stiffness_factors.hpp"

#include <algorithm>
#include <klu.h>

#include <Eigen/LU>

namespace scree::response {

namespace {

// Largest number of rows for which a dense factorisation is used.
constexpr Eigen::Index largest_dense = 100;

}  // namespace

struct StiffnessFactors::Dense {
  Eigen::PartialPivLU<Eigen::MatrixXd> factors;
};

// Factorises with KLU. Keeps the order of elimination as long as the same entries are non-zero, and the
// pivots as long as they do not grow.
class StiffnessFactors::Sparse {
 public:
  Sparse() { klu_defaults(&common_); }
  Sparse(const Sparse&) = delete;
  Sparse& operator=(const Sparse&) = delete;
  ~Sparse() { forget(); }

  bool factorise(Eigen::SparseMatrix<double> matrix) {
    matrix.makeCompressed();
    const bool same = numeric_ && same_entries(matrix);
    matrix_.swap(matrix);
    return (same && factorise_again()) || factorise_anew();
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& load) const {
    Eigen::VectorXd x = load;
    klu_solve(symbolic_, numeric_, size(), 1, x.data(), &common_);
    return x;
  }

 private:
  // Reciprocal growth of pivots below which new pivots are chosen.
  static constexpr double least_reciprocal_growth = 1e-6;

  int size() const { return int(matrix_.rows()); }
  int* columns() { return matrix_.outerIndexPtr(); }
  int* rows() { return matrix_.innerIndexPtr(); }

  bool same_entries(const Eigen::SparseMatrix<double>& matrix) const {
    return matrix.rows() == matrix_.rows() && matrix.nonZeros() == matrix_.nonZeros() &&
           std::equal(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.cols() + 1,
                      matrix_.outerIndexPtr()) &&
           std::equal(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros(),
                      matrix_.innerIndexPtr());
  }

  // Uses the previous pivots.
  bool factorise_again() {
    return klu_refactor(columns(), rows(), matrix_.valuePtr(), symbolic_, numeric_, &common_) &&
           common_.status == KLU_OK &&
           klu_rgrowth(columns(), rows(), matrix_.valuePtr(), symbolic_, numeric_, &common_) &&
           common_.rgrowth > least_reciprocal_growth;
  }

  bool factorise_anew() {
    forget();
    symbolic_ = klu_analyze(size(), columns(), rows(), &common_);
    if (!symbolic_) return false;
    numeric_ = klu_factor(columns(), rows(), matrix_.valuePtr(), symbolic_, &common_);
    return numeric_ != nullptr;
  }

  void forget() {
    if (numeric_) klu_free_numeric(&numeric_, &common_);
    if (symbolic_) klu_free_symbolic(&symbolic_, &common_);
  }

  Eigen::SparseMatrix<double> matrix_;
  mutable klu_common common_;
  klu_symbolic* symbolic_ = nullptr;
  klu_numeric* numeric_ = nullptr;
};

StiffnessFactors::StiffnessFactors() = default;
StiffnessFactors::~StiffnessFactors() = default;

bool StiffnessFactors::factorise(const Eigen::SparseMatrix<double>& stiffness,
                                 const Eigen::VectorXd& diagonal) {
  if (stiffness.rows() <= largest_dense) {
    Eigen::MatrixXd matrix = stiffness;
    matrix.diagonal() += diagonal;
    dense_ = std::make_unique<Dense>(Dense{matrix.partialPivLu()});
    factorised_ = true;
    return true;
  }
  if (!sparse_) sparse_ = std::make_unique<Sparse>();
  Eigen::SparseMatrix<double> added(stiffness.rows(), stiffness.cols());
  added.setIdentity();
  added.diagonal() = diagonal;
  factorised_ = sparse_->factorise(stiffness + added);
  return factorised_;
}

Eigen::VectorXd StiffnessFactors::solve(const Eigen::VectorXd& load) const {
  return dense_ ? Eigen::VectorXd(dense_->factors.solve(load)) : sparse_->solve(load);
}

}  // namespace scree::response
