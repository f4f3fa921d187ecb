#include "modes/krylov.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace scree::response {

namespace {

using Matrix = Eigen::MatrixXd;
using Index = Eigen::Index;

constexpr int most_restarts = 200;
// Columns shorter than this share of the longest product are round-off.
constexpr double negligible = 1e-14;

class Lanczos {
 public:
  Lanczos(const Operator& a, const Matrix& start, const KrylovOptions& options)
      : a_(a),
        options_(options),
        capacity_(std::min(start.rows(), 2 * options.wanted + 8 * start.cols() + 60)),
        vectors_(start.rows(), capacity_),
        projected_(Matrix::Zero(capacity_, capacity_)) {
    factorise(start, 1);
  }

  KrylovResult run() {
    for (int restart = 0; restart <= most_restarts; ++restart) {
      while (next_.cols() > 0 && size_ + next_.cols() <= capacity_) {
        if (!options_.proceed()) return converged();
        extend();
        if (done()) return converged();
      }
      if (next_.cols() == 0 || capacity_ == vectors_.rows()) break;
      keep_best();
    }
    return converged();
  }

 private:
  // Makes `next_` orthonormal columns of the span of w, and `coupling_` of w = next_ coupling_. The longest
  // column of products has the length `scale`.
  void factorise(const Matrix& w, double scale) {
    const Eigen::ColPivHouseholderQR<Matrix> qr(w);
    Index rank = 0;
    const Index most = std::min(w.cols(), w.rows() - size_);
    while (rank < most && std::abs(qr.matrixR()(rank, rank)) > negligible * scale) ++rank;
    next_ = qr.householderQ() * Matrix::Identity(w.rows(), rank);
    const Matrix upper = qr.matrixR().topRows(rank).template triangularView<Eigen::Upper>();
    coupling_ = upper * qr.colsPermutation().transpose();
  }

  void extend() {
    const Index from = size_, added = next_.cols();
    vectors_.middleCols(from, added) = next_;
    Matrix product = a_(next_);
    size_ += added, last_ = added;
    const double scale = product.colwise().norm().maxCoeff();
    largest_ = std::max(largest_, scale);
    const auto basis = vectors_.leftCols(size_);
    Matrix shares = Matrix::Zero(size_, added);
    for (int pass = 0; pass < 2; ++pass) {
      const Matrix more = basis.transpose() * product;
      product.noalias() -= basis * more;
      shares += more;
    }
    projected_.block(0, from, size_, added) = shares;
    projected_.block(from, 0, added, from) = shares.topRows(from).transpose();
    factorise(product, largest_);
    if (next_.cols() == 0) return;
    // What round-off left of the basis in short columns.
    const Matrix left = basis.transpose() * next_;
    next_.noalias() -= basis * left;
    const Matrix overlaps = next_.transpose() * next_;
    const Eigen::LLT<Matrix> factors(overlaps);
    factors.matrixU().solveInPlace<Eigen::OnTheRight>(next_);
  }

  // Eigenvalues of the projected operator in the order wanted; residuals follow from what the last block
  // leaves.
  void solve_projected() {
    const Matrix part = projected_.topLeftCorner(size_, size_);
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(0.5 * (part + part.transpose()));
    std::vector<Index> order(std::size_t(size_), 0);
    std::iota(order.begin(), order.end(), Index(0));
    const Eigen::VectorXd& values = solver.eigenvalues();
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
      return options_.both_ends ? std::abs(values[a]) > std::abs(values[b]) : values[a] > values[b];
    });
    values_ = values(order);
    shares_ = solver.eigenvectors()(Eigen::all, order);
    residuals_ = (coupling_ * shares_.bottomRows(last_)).colwise().norm();
  }

  Index leading_converged() const {
    Index count = 0;
    while (count < std::min(size_, options_.wanted) && is_wanted(count) &&
           residuals_[count] <= options_.tolerance * std::abs(values_[count]))
      ++count;
    return count;
  }
  bool is_wanted(Index k) const { return options_.both_ends || values_[k] > 0; }

  bool done() {
    solve_projected();
    options_.on_step(leading_converged());
    return leading_converged() == options_.wanted;
  }

  void keep_best() {
    const Index kept = std::min(size_ - last_, options_.wanted + 2 * last_ + 10);
    vectors_.leftCols(kept) = (vectors_.leftCols(size_) * shares_.leftCols(kept)).eval();
    projected_.setZero();
    projected_.diagonal().head(kept) = values_.head(kept);
    size_ = kept;
    // What is converged may be wanted before the next block.
    shares_ = Matrix::Identity(kept, kept);
    values_ = values_.head(kept).eval();
    residuals_ = residuals_.head(kept).eval();
  }

  KrylovResult converged() const {
    if (size_ == 0) return {Matrix(vectors_.rows(), 0), Eigen::VectorXd(0)};
    const Index count = leading_converged();
    return {vectors_.leftCols(size_) * shares_.leftCols(count), values_.head(count)};
  }

  const Operator& a_;
  const KrylovOptions& options_;
  Index capacity_, size_ = 0, last_ = 0;
  Matrix vectors_, projected_;
  Matrix next_, coupling_;  // A vectors = vectors projected + next coupling, in the columns of the last block
  Eigen::VectorXd values_, residuals_;
  Matrix shares_;
  double largest_ = 0;
};

}  // namespace

KrylovResult krylov(const Operator& a, const Eigen::MatrixXd& start, const KrylovOptions& options) {
  return Lanczos(a, start, options).run();
}

}  // namespace scree::response
