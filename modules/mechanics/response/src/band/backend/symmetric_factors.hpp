#pragma once

#include "band/backend/band_backend.hpp"
#include "band/backend/elimination.hpp"

#include <algorithm>
#include <atomic>
#include <functional>
#include <vector>

#include <Eigen/Dense>

namespace scree::response {

// A = L D Lᵀ of a symmetric, real or complex matrix by multifrontal elimination. Pivots are sought within
// supernodes, so that it is an approximation where those are nearly singular: largest_term() is then large.
template <class T>
class SymmetricFactors {
 public:
  using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
  // A block of D, and the largest of the numbers whose sum it is.
  using OnPivot = std::function<void(const Matrix& pivot, double largest_term)>;

  // Reads the entries of A below the diagonal in the order of elimination. Once `*stop` is true the factors
  // are incomplete and must not be used; `stop` may be null.
  SymmetricFactors(const Elimination& plan, const Eigen::SparseMatrix<T>& a,
                   const std::atomic<bool>* stop = nullptr, const OnPivot& on_pivot = {})
      : plan_(plan) {
    const std::size_t count = plan.nodes.size();
    pivots_.resize(count), couplings_.resize(count), updates_.resize(count), at_.resize(plan.order.size());
    terms_.assign(count, 0);
    std::vector<std::vector<int>> children(count);
    for (std::size_t k = 0; k < count; ++k)
      if (plan.nodes[k].parent >= 0) children[std::size_t(plan.nodes[k].parent)].push_back(int(k));
    for (std::size_t k = 0; k < count && !(stop && *stop); ++k) eliminate(k, a, children[k], on_pivot);
    updates_.clear();
  }

  Eigen::Index size() const { return Eigen::Index(plan_.order.size()); }

  // The largest number that was added to another in the elimination, found only with on_pivot. Times the
  // round-off of a number it estimates by how much A differs from the product of its factors.
  double largest_term() const { return terms_.empty() ? 0 : *std::max_element(terms_.begin(), terms_.end()); }

  // Solves A x = b for each column of b.
  Matrix solve(const Matrix& b) const {
    Matrix x(b.rows(), b.cols()), part, rest;
    for (Eigen::Index c = 0; c < b.cols(); ++c)
      for (Eigen::Index i = 0; i < b.rows(); ++i) x(i, c) = b(plan_.order[std::size_t(i)], c);
    for (std::size_t k = 0; k < plan_.nodes.size(); ++k) {
      const Supernode& node = plan_.nodes[k];
      part = x.middleRows(node.first, node.width);
      rest.noalias() = couplings_[k].transpose() * part;
      for (Eigen::Index c = 0; c < b.cols(); ++c)
        for (std::size_t i = 0; i < node.rows.size(); ++i) x(node.rows[i], c) -= rest(Eigen::Index(i), c);
      x.middleRows(node.first, node.width) = pivots_[k].solve(part);
    }
    for (std::size_t k = plan_.nodes.size(); k-- > 0;) {
      const Supernode& node = plan_.nodes[k];
      rest.resize(Eigen::Index(node.rows.size()), b.cols());
      for (Eigen::Index c = 0; c < b.cols(); ++c)
        for (std::size_t i = 0; i < node.rows.size(); ++i) rest(Eigen::Index(i), c) = x(node.rows[i], c);
      x.middleRows(node.first, node.width).noalias() -= couplings_[k] * rest;
    }
    Matrix sorted(b.rows(), b.cols());
    for (Eigen::Index c = 0; c < b.cols(); ++c)
      for (Eigen::Index i = 0; i < b.rows(); ++i) sorted(plan_.order[std::size_t(i)], c) = x(i, c);
    return sorted;
  }

 private:
  static constexpr Eigen::Index stripe = 128;  // columns of an update at once: its upper half is not computed

  // Rows of the front of supernode k, its columns and what it leaves for later ones: lower halves.
  void eliminate(std::size_t k, const Eigen::SparseMatrix<T>& a, const std::vector<int>& children,
                 const OnPivot& on_pivot) {
    const Supernode& node = plan_.nodes[k];
    const Eigen::Index width = node.width, rest = Eigen::Index(node.rows.size());
    for (int j = 0; j < node.width; ++j) at_[std::size_t(node.first + j)] = j;
    for (std::size_t i = 0; i < node.rows.size(); ++i) at_[std::size_t(node.rows[i])] = node.width + int(i);
    Matrix front = Matrix::Zero(width + rest, width), update = Matrix::Zero(rest, rest);
    for (int j = 0; j < node.width; ++j)
      for (typename Eigen::SparseMatrix<T>::InnerIterator e(a, plan_.order[std::size_t(node.first + j)]); e;
           ++e) {
        const int row = plan_.place[std::size_t(e.row())];
        if (row >= node.first + j) front(at_[std::size_t(row)], j) += e.value();
      }
    if (on_pivot) {
      terms_[k] = largest(front);
      for (const int child : children) terms_[k] = std::max(terms_[k], terms_[std::size_t(child)]);
    }
    for (const int child : children) add_update(std::size_t(child), front, update);

    Matrix pivot = front.topRows(width);
    pivot.template triangularView<Eigen::StrictlyUpper>() = front.topRows(width).transpose();
    if (on_pivot) on_pivot(pivot, terms_[k]);
    pivots_[k].compute(pivot);
    couplings_[k].resize(width, rest);
    if (rest > 0) couplings_[k] = pivots_[k].solve(front.bottomRows(rest).transpose());
    if (on_pivot && rest > 0)
      terms_[k] = std::max(terms_[k], largest(front.bottomRows(rest)) * largest(couplings_[k]));
    for (Eigen::Index c = 0; c < rest; c += stripe) {
      const Eigen::Index columns = std::min(stripe, rest - c);
      update.block(c, c, rest - c, columns).noalias() -=
          front.block(width + c, 0, rest - c, width) * couplings_[k].middleCols(c, columns);
    }
    updates_[k] = std::move(update);
  }

  static double largest(const Eigen::Ref<const Matrix>& numbers) {
    return double(numbers.cwiseAbs().maxCoeff());
  }

  void add_update(std::size_t child, Matrix& front, Matrix& update) {
    const std::vector<int>& rows = plan_.nodes[child].rows;
    for (std::size_t c = 0; c < rows.size(); ++c) {
      const int column = at_[std::size_t(rows[c])];
      const bool eliminated = column < front.cols();
      T* const sum = eliminated ? &front(0, column) : &update(0, column - front.cols()) - front.cols();
      for (std::size_t r = c; r < rows.size(); ++r)
        sum[at_[std::size_t(rows[r])]] += updates_[child](Eigen::Index(r), Eigen::Index(c));
    }
    updates_[child].resize(0, 0);
  }

  const Elimination& plan_;
  std::vector<Eigen::PartialPivLU<Matrix>> pivots_;
  std::vector<Matrix> couplings_;  // pivot⁻¹ times the rows coupled to it, transposed
  std::vector<Matrix> updates_;
  std::vector<double> terms_;  // of each supernode and those before it, the largest number that is added
  std::vector<int> at_;        // place in the present front
};

// Signs of the eigenvalues of a symmetric matrix, or of the blocks into which it is reduced.
struct PivotSigns {
  int negative = 0;
  double smallest;      // |eigenvalue| next to 0
  double largest_term;  // added in the reduction
};
PivotSigns signs_of(Eigen::MatrixXd matrix);

// stiffness: symmetric, with both halves; mass: diagonal.
std::unique_ptr<ShiftBackend> make_shifts(const SparseView& stiffness, const double* mass);

}  // namespace scree::response
