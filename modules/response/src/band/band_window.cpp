#include "band_backend.hpp"
#include "galerkin_basis.hpp"
#include "shifted_factors.hpp"
#include "symmetric_factors.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace scree::response {

namespace {

using Matrix = Eigen::MatrixXcd;
using Sparse = Eigen::SparseMatrix<double>;

// Rounds of iteration, after which more frequencies are cheaper with a factorisation nearer to them.
constexpr int most_rounds = 14;
// Changes that fall more slowly from round to round say little about what is left: a tenth may have been found.
constexpr double slowest_decay = 0.9;
// A mode near the frequency that enters the basis late lets a round change the solution by less than its error, rarely two rounds.
constexpr double caution = 2;
// Before the first change, the whole amplitude is unknown.
constexpr double slowest_start = 1;

// Iteration at the frequencies of a window. In each round, residuals are multiplied by the approximate inverse, and
// the directions found added to the basis; the change of the solution by them is the error of the one before, which
// is stated for the newer one too.
class WindowIteration {
 public:
  WindowIteration(const BandWindow& window, const Sparse& stiffness, const Sparse& damping,
                  const Eigen::VectorXd& mass)
      : window_(window),
        size_(mass.size()),
        loads_(Eigen::Map<const Matrix>(window.load, size_, window.count)),
        basis_(stiffness, damping, mass, std::min<Eigen::Index>(size_, 2 + most_rounds * window.count)),
        open_(std::size_t(window.count)),
        changes_(Eigen::VectorXd::Constant(window.count, slowest_start)),
        errors_(Eigen::VectorXd::Constant(window.count, std::numeric_limits<double>::infinity())) {
    for (int k = 0; k < window.count; ++k) open_[std::size_t(k)] = k;
    std::fill_n(window.error, window.count, std::numeric_limits<double>::quiet_NaN());
  }

  template <class Inverse>
  int run(const Inverse& inverse) {
    if (!settle_unloaded()) return 0;
    Matrix directions = unit(inverse(loads_));
    if (!directions.allFinite()) return 0;
    basis_.extend(directions);
    solve_open();
    for (int round = 0; round < most_rounds && !open_.empty(); ++round) {
      const Eigen::Index before = basis_.size();
      directions = unit(inverse(residuals_));
      if (!directions.allFinite()) break;
      basis_.extend(directions);
      if (basis_.size() == before) break;
      const Matrix older = solutions_;
      solve_open();
      estimate_errors(older);
      write_open();
      close_found();
    }
    write_open();
    return int(basis_.size());
  }

 private:
  // The columns of open frequencies.
  Matrix open_loads() const {
    Matrix loads(size_, Eigen::Index(open_.size()));
    for (std::size_t k = 0; k < open_.size(); ++k) loads.col(Eigen::Index(k)) = loads_.col(open_[k]);
    return loads;
  }

  // Without a load the solution is 0. Returns whether a frequency is left.
  bool settle_unloaded() {
    std::erase_if(open_, [&](int k) {
      if (loads_.col(k).norm() > 0) return false;
      Eigen::Map<Matrix>(window_.amplitude, size_, window_.count).col(k).setZero();
      window_.residual[k] = window_.error[k] = 0;
      return true;
    });
    return !open_.empty();
  }

  static Matrix unit(Matrix columns) {
    for (Eigen::Index c = 0; c < columns.cols(); ++c) {
      const double length = columns.col(c).norm();
      if (length > 0) columns.col(c) /= length;
    }
    return columns;
  }

  void solve_open() {
    Eigen::VectorXd omega(open_.size());
    const Matrix loads = open_loads();
    Matrix coefficients(basis_.size(), loads.cols());
    for (Eigen::Index k = 0; k < loads.cols(); ++k) {
      omega[k] = window_.omega[open_[std::size_t(k)]];
      coefficients.col(k) = basis_.coefficients(omega[k], loads.col(k));
    }
    solutions_ = basis_.vectors(coefficients);
    residuals_ = basis_.residuals(omega, loads, coefficients);
  }

  void estimate_errors(const Matrix& older) {
    for (Eigen::Index k = 0; k < Eigen::Index(open_.size()); ++k) {
      const int at = open_[std::size_t(k)];
      const double change = (solutions_.col(k) - older.col(k)).norm() / solutions_.col(k).norm();
      // The sum of further changes, each smaller than the one before as this one is.
      const double ratio = std::min(change / changes_[at], slowest_decay);
      errors_[at] = caution * std::max(change, changes_[at]) / (1 - ratio);
      changes_[at] = change;
    }
  }

  void write_open() {
    for (Eigen::Index k = 0; k < Eigen::Index(open_.size()); ++k) {
      const int at = open_[std::size_t(k)];
      Eigen::Map<Matrix>(window_.amplitude, size_, window_.count).col(at) = solutions_.col(k);
      window_.residual[at] = residuals_.col(k).norm() / loads_.col(at).norm();
      // In a basis of the whole space only round-off is left.
      window_.error[at] = basis_.size() == size_ ? window_.residual[at] : errors_[at];
    }
  }

  void close_found() {
    std::vector<int> still_open;
    std::vector<Eigen::Index> columns;
    for (Eigen::Index k = 0; k < Eigen::Index(open_.size()); ++k) {
      if (errors_[open_[std::size_t(k)]] <= window_.tolerance) continue;
      still_open.push_back(open_[std::size_t(k)]);
      columns.push_back(k);
    }
    if (columns.size() == open_.size()) return;
    open_ = still_open;
    solutions_ = Matrix(solutions_(Eigen::all, columns));
    residuals_ = Matrix(residuals_(Eigen::all, columns));
  }

  const BandWindow& window_;
  Eigen::Index size_;
  Eigen::Map<const Matrix> loads_;
  GalerkinBasis basis_;
  std::vector<int> open_;    // frequencies whose solution is not found
  Eigen::VectorXd changes_;  // of each frequency in the last round, over its amplitude
  Eigen::VectorXd errors_;   // of each frequency, estimated, over its amplitude
  Matrix solutions_, residuals_;
};

class BandSolver : public BandBackend {
 public:
  BandSolver(const SparseView& stiffness, const SparseView& damping, const double* mass)
      : stiffness_(copy_of(stiffness)),
        damping_(copy_of(damping)),
        mass_(Eigen::Map<const Eigen::VectorXd>(mass, stiffness.size)),
        // Round-off of the assembly does not make its diagonal incomplete.
        symmetric_stiffness_(0.5 * (stiffness_ + Sparse(stiffness_.transpose()))),
        symmetric_damping_(0.5 * (damping_ + Sparse(damping_.transpose()))),
        plan_(plan_elimination(pattern())) {}

  int solve(const BandWindow& window) const override {
    return window.single_precision ? solve_with<std::complex<float>>(window)
                                   : solve_with<std::complex<double>>(window);
  }

 private:
  Sparse pattern() const {
    Sparse identity(mass_.size(), mass_.size());
    identity.setIdentity();
    const Sparse all = symmetric_stiffness_.cwiseAbs() + symmetric_damping_.cwiseAbs();
    return all + identity;
  }

  template <class T>
  int solve_with(const BandWindow& window) const {
    const double omega = window.omega[window.count / 2];
    Sparse inertia(mass_.size(), mass_.size());
    inertia.setIdentity();
    inertia = Sparse(mass_.asDiagonal() * inertia) * (omega * omega);
    const Sparse elastic = symmetric_stiffness_ - inertia;
    Eigen::SparseMatrix<std::complex<double>> sum = elastic.cast<std::complex<double>>();
    sum += std::complex<double>(0, omega) * symmetric_damping_.cast<std::complex<double>>();
    const SymmetricFactors<T> factors(plan_, sum.template cast<T>());
    WindowIteration iteration(window, stiffness_, damping_, mass_);
    return iteration.run([&](const Matrix& b) -> Matrix {
      // Directions count, not lengths: scaled, since single precision has a small range.
      Matrix scaled = b;
      for (Eigen::Index c = 0; c < b.cols(); ++c)
        if (const double length = b.col(c).norm(); length > 0) scaled.col(c) /= length;
      return factors.solve(scaled.template cast<T>()).template cast<std::complex<double>>();
    });
  }

  Sparse stiffness_, damping_;
  Eigen::VectorXd mass_;
  Sparse symmetric_stiffness_, symmetric_damping_;
  Elimination plan_;
};

class Factory : public BandBackendFactory {
  std::unique_ptr<BandBackend> create(const SparseView& stiffness, const SparseView& damping,
                                      const double* mass) const override {
    return std::make_unique<BandSolver>(stiffness, damping, mass);
  }
  std::unique_ptr<ShiftBackend> create_shifts(const SparseView& stiffness,
                                              const double* mass) const override {
    return make_shifts(stiffness, mass);
  }
};

}  // namespace

}  // namespace scree::response

extern "C" __attribute__((visibility("default"))) scree::response::BandBackendFactory*
scree_create_band_backend(int version) {
  static scree::response::Factory factory;
  return version == scree::response::band_backend_version ? &factory : nullptr;
}
