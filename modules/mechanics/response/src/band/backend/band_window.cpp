#include "band/backend/band_backend.hpp"
#include "band/backend/galerkin_basis.hpp"
#include "band/backend/symmetric_factors.hpp"
#include "band/singular.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace scree::response {

namespace {

using Matrix = Eigen::MatrixXcd;
using Sparse = Eigen::SparseMatrix<double>;

// Rounds of iteration after which a factorisation nearer to the remaining frequencies is cheaper.
constexpr int most_rounds = 14;
// Frequencies whose residuals extend the basis while changes are large. More of them add few directions,
// since neighbouring residuals differ little.
constexpr int most_sources = 4;
// Largest ratio of successive changes in an error estimate. Slower decay says little about the remaining
// error.
constexpr double slowest_decay = 0.9;
// Factor of the error estimate: before a mode near the frequency enters the basis, one round, rarely two, may
// change the solution by less than its error.
constexpr double caution = 3;
// The relative change assumed before the first round: the whole amplitude.
constexpr double slowest_start = 1;

// Iteration at the frequencies of a window. Each round multiplies residuals by the approximate inverse and
// adds the resulting directions to the basis. The change of a solution is the error of the previous one, and
// is stated for the new one too. While changes are too large, residuals of a few frequencies serve all. A
// solution counts as found only after a round with its own residual: directions from other frequencies show
// only what those lack.
class WindowIteration {
 public:
  WindowIteration(const BandWindow& window, const Sparse& stiffness, const Sparse& damping,
                  const Eigen::VectorXd& mass)
      : window_(window),
        size_(mass.size()),
        loads_(Eigen::Map<const Matrix>(window.load, size_, window.count)),
        basis_(stiffness, damping, mass,
               std::min<Eigen::Index>(size_, 2 + most_rounds * most_sources + 2 * window.count)),
        changes_(Eigen::VectorXd::Constant(window.count, slowest_start)),
        errors_(Eigen::VectorXd::Constant(window.count, std::numeric_limits<double>::infinity())) {
    for (int k = 0; k < window.count; ++k) open_.push_back(k);
    std::fill_n(window.error, window.count, std::numeric_limits<double>::quiet_NaN());
  }

  // norm: norm of the factorised matrix.
  template <class Inverse>
  int run(const Inverse& inverse, double norm) {
    if (!zero_unloaded()) return 0;
    Matrix directions = inverse(loads_of(frequencies(spread_sample(all_open()))));
    if (!directions.allFinite()) return 0;
    // In single precision, and between frequencies, only the iteration shows whether it converges.
    if (window_.count == 1 && directions.norm() * norm > largest_amplification) return 0;
    directions = unit(std::move(directions));
    basis_.extend(directions);
    solve_open();
    for (int round = 0; round < most_rounds && !open_.empty() && proceeds(); ++round) {
      const Eigen::Index before = basis_.size();
      const Places far = far_open();
      directions = unit(inverse(residuals(far.empty() ? all_open() : spread_sample(far))));
      if (!directions.allFinite()) break;
      basis_.extend(directions);
      if (basis_.size() == before) break;
      const Matrix older = coefficients_;
      solve_open();
      estimate_errors(older);
      if (far.empty()) close_found();
    }
    write(all_open());
    return int(basis_.size());
  }

 private:
  using Places = std::vector<Eigen::Index>;  // in open_

  Places all_open() const {
    Places all(open_.size());
    std::iota(all.begin(), all.end(), Eigen::Index(0));
    return all;
  }

  // Open frequencies whose errors are above the tolerance.
  Places far_open() const {
    Places far;
    for (const Eigen::Index k : all_open())
      if (!(errors_[open_[std::size_t(k)]] <= window_.tolerance)) far.push_back(k);
    return far;
  }

  // At most `most_sources` places, from the lowest to the highest frequency.
  static Places spread_sample(const Places& places) {
    const std::size_t count = std::min(places.size(), std::size_t(most_sources));
    Places few;
    for (std::size_t k = 0; k < count; ++k)
      few.push_back(places[count == 1 ? 0 : k * (places.size() - 1) / (count - 1)]);
    return few;
  }

  std::vector<int> frequencies(const Places& places) const {
    std::vector<int> chosen;
    for (const Eigen::Index place : places) chosen.push_back(open_[std::size_t(place)]);
    return chosen;
  }

  Matrix loads_of(const std::vector<int>& frequencies) const { return loads_(Eigen::all, frequencies); }

  Matrix residuals(const Places& places) const {
    const std::vector<int> chosen = frequencies(places);
    Eigen::VectorXd omega(places.size());
    for (std::size_t k = 0; k < chosen.size(); ++k) omega[Eigen::Index(k)] = window_.omega[chosen[k]];
    return basis_.residuals(omega, loads_of(chosen), coefficients_(Eigen::all, places));
  }

  bool proceeds() const { return !window_.stop || !*window_.stop; }

  // Closes frequencies without a load, whose solution is 0. Returns whether any frequency is left.
  bool zero_unloaded() {
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
    coefficients_.resize(basis_.size(), Eigen::Index(open_.size()));
    for (std::size_t k = 0; k < open_.size(); ++k)
      coefficients_.col(Eigen::Index(k)) = basis_.coefficients(window_.omega[open_[k]], loads_.col(open_[k]));
  }

  // The basis is orthonormal, so that coefficients are as long as solutions.
  void estimate_errors(const Matrix& older) {
    for (Eigen::Index k = 0; k < Eigen::Index(open_.size()); ++k) {
      const int at = open_[std::size_t(k)];
      Eigen::VectorXcd step = coefficients_.col(k);
      step.head(older.rows()) -= older.col(k);
      const double change = step.norm() / coefficients_.col(k).norm();
      // The sum of all further changes if each is smaller than the previous one by this ratio.
      const double ratio = std::min(change / changes_[at], slowest_decay);
      errors_[at] = caution * std::max(change, changes_[at]) / (1 - ratio);
      changes_[at] = change;
    }
  }

  void write(const Places& places) {
    if (places.empty()) return;
    const Matrix solutions = basis_.vectors(coefficients_(Eigen::all, places)), rest = residuals(places);
    for (Eigen::Index k = 0; k < solutions.cols(); ++k) {
      const int at = open_[std::size_t(places[std::size_t(k)])];
      Eigen::Map<Matrix>(window_.amplitude, size_, window_.count).col(at) = solutions.col(k);
      window_.residual[at] = rest.col(k).norm() / loads_.col(at).norm();
      // In a basis of the whole space only round-off remains.
      window_.error[at] = basis_.size() == size_ ? window_.residual[at] : errors_[at];
    }
  }

  void close_found() {
    Places found, left;
    for (const Eigen::Index k : all_open())
      (errors_[open_[std::size_t(k)]] <= window_.tolerance ? found : left).push_back(k);
    write(found);
    open_ = frequencies(left);
    coefficients_ = Matrix(coefficients_(Eigen::all, left));
  }

  const BandWindow& window_;
  Eigen::Index size_;
  Eigen::Map<const Matrix> loads_;
  GalerkinBasis basis_;
  std::vector<int> open_;    // frequencies whose solution is not found
  Eigen::VectorXd changes_;  // of each frequency in the last round, over its amplitude
  Eigen::VectorXd errors_;   // of each frequency, estimated, over its amplitude
  Matrix coefficients_;      // of the solutions at open frequencies in the basis
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
    const SymmetricFactors<T> factors(plan_, sum.template cast<T>(), window.stop);
    if (window.stop && *window.stop) return 0;
    WindowIteration iteration(window, stiffness_, damping_, mass_);
    const auto inverse = [&](const Matrix& b) -> Matrix {
      // Directions count, not lengths: scaled, since single precision has a small range.
      Matrix scaled = b;
      for (Eigen::Index c = 0; c < b.cols(); ++c)
        if (const double length = b.col(c).norm(); length > 0) scaled.col(c) /= length;
      return factors.solve(scaled.template cast<T>()).template cast<std::complex<double>>();
    };
    return iteration.run(inverse, sum.norm());
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
