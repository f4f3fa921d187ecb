#pragma once

#include <memory>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace scree::response {

// LU factors of a stiffness matrix with a diagonal added: dense for small matrices, else sparse (KLU).
class StiffnessFactors {
 public:
  StiffnessFactors();
  ~StiffnessFactors();

  // Returns false if the matrix is singular.
  bool factorise(const Eigen::SparseMatrix<double>& stiffness, const Eigen::VectorXd& diagonal);
  explicit operator bool() const { return factorised_; }
  void discard() { factorised_ = false; }
  Eigen::VectorXd solve(const Eigen::VectorXd& load) const;

 private:
  struct Dense;
  class Sparse;
  std::unique_ptr<Dense> dense_;
  std::unique_ptr<Sparse> sparse_;
  bool factorised_ = false;
};

}  // namespace scree::response
