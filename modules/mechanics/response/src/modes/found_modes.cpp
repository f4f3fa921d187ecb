#include "assembly/mass_weighted.hpp"
#include "band/backend/band_backend.hpp"
#include "modes/krylov.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <scree/response/found_modes.hpp>

namespace scree::response {

namespace {

using Matrix = Eigen::MatrixXd;
using Index = Eigen::Index;

constexpr std::size_t most_unstable = 200;  // modes whose shapes are computed
constexpr Index narrow_block = 8, widest_block = 100, spare = 2;
// Smallest relative gap between neighbouring ω² in which modes can be counted.
constexpr double smallest_gap = 1e-7;
constexpr int most_rounds = 6;
constexpr double round_off = 1e-13;  // an asymmetry below this is round-off

// The search, in the coordinates √M q of all degrees of freedom.
class Search {
 public:
  Search(const UndampedSystem& system, const ModeSearch& search)
      : system_(system), search_(search), modes_(system.symmetric_stiffness().rows(), 0) {}

  FoundModes run() {
    const double rounding = system_.rounding();
    search_.on_progress(0, "counting floppy modes");
    const std::unique_ptr<ShiftedFactors> below = system_.factorise(-rounding);
    result_.unstable = number(system_.count_below(*below));
    result_.counted = search_.proceed();
    // By round-off there may be fewer below `rounding` than below −`rounding`.
    if (result_.counted)
      result_.floppy = std::max(number(system_.count_below(rounding)), result_.unstable) - result_.unstable;
    resting_ = result_.unstable + result_.floppy;
    find(*below, Index(result_.floppy), true);
    find_unstable();
    held_ = modes_.cols();
    if (search_.proceed() && system_.asymmetry() > round_off && resting_ > 0) apply_asymmetry(*below);
    if (search_.count > 0 && search_.near_hz > 0)
      find_near();
    else if (search_.count > 0)
      find_lowest(*below);
    return write();
  }

 private:
  std::size_t number(const ModeCount& counted) {
    result_.certain &= counted.certain;
    return counted.modes;
  }

  // The inverse, for components with mass and across the modes that are found already.
  Matrix invert(const ShiftedFactors& factors, const Matrix& heavy) const {
    Matrix x = without_found(heavy);
    x = heavy_part(solved(factors, x));
    return without_found(x);
  }

  Matrix solved(const ShiftedFactors& factors, const Matrix& heavy) const {
    Matrix all = Matrix::Zero(modes_.rows(), heavy.cols());
    all(system_.heavy(), Eigen::all) = heavy;
    factors.solve(all.data(), int(all.cols()));
    return all;
  }

  Matrix heavy_part(const Matrix& all) const { return all(system_.heavy(), Eigen::all); }

  Matrix without_found(const Matrix& heavy) const {
    if (modes_.cols() == 0) return heavy;
    const Matrix found = heavy_part(modes_);
    Matrix rest = heavy;
    const Matrix shares = found.transpose() * rest;
    rest.noalias() -= found * shares;
    return rest;
  }

  // Adds `wanted` further modes next to the shift, or above it.
  void find(const ShiftedFactors& factors, Index wanted, bool both_sides) {
    const Index target = modes_.cols() + std::min(wanted, Index(system_.modes()) - modes_.cols());
    for (int round = 0; modes_.cols() < target && round < most_rounds && search_.proceed(); ++round) {
      const Index before = modes_.cols(), missing = target - before;
      const Index block = std::min(
          {std::max(narrow_block, std::min(missing + spare, widest_block)), Index(system_.modes()) - before});
      const KrylovResult found =
          krylov([&](const Matrix& x) { return invert(factors, x); }, without_found(random(block)),
                 {.wanted = missing,
                  .both_ends = both_sides,
                  .proceed = search_.proceed,
                  .on_step = [&](Index converged) {
                    search_.on_progress(double(before + converged) / double(target), "modes");
                  }});
      if (found.vectors.cols() == 0) continue;
      add(solved(factors, found.vectors));
    }
  }

  // Adds the modes of the symmetric part of K in the span of vectors that satisfy the equations of massless walls.
  void add(Matrix vectors) {
    vectors *= heavy_part(vectors).colwise().norm().cwiseInverse().asDiagonal();
    for (int pass = 0; pass < 2; ++pass) {
      if (modes_.cols() > 0) {
        const Matrix shares = heavy_part(modes_).transpose() * heavy_part(vectors);
        vectors -= modes_ * shares;
      }
      const Matrix heavy = heavy_part(vectors);
      const Eigen::LLT<Matrix> factors(Matrix(heavy.transpose() * heavy));
      factors.matrixU().solveInPlace<Eigen::OnTheRight>(vectors);
    }
    const Matrix projected = vectors.transpose() * (system_.symmetric_stiffness() * vectors);
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(0.5 * (projected + projected.transpose()));
    Matrix all(modes_.rows(), modes_.cols() + vectors.cols());
    all << modes_, vectors * solver.eigenvectors();
    modes_ = std::move(all);
    const std::size_t before = squares_.size();
    squares_.resize(before + std::size_t(vectors.cols()));
    for (Index k = 0; k < vectors.cols(); ++k) squares_[before + std::size_t(k)] = solver.eigenvalues()[k];
  }

  // Finds unstable modes with a shift below all of them.
  void find_unstable() {
    if (result_.unstable == 0 || result_.unstable > most_unstable) return;
    double shift = -system_.rounding();
    std::unique_ptr<ShiftedFactors> factors;
    do {
      search_.on_progress(0, "unstable modes");
      shift *= 10;
      factors = system_.factorise(shift);
    } while (search_.proceed() && shift > -system_.largest() && number(system_.count_below(*factors)) > 0);
    find(*factors, Index(result_.unstable), true);
  }

  // Turns modes of the symmetric part with ω² <= 0 into modes of the full K: bodies that turn freely between two contacts
  // are floppy with the full K, but have an ω² below 0, of second order in the asymmetry, with its symmetric part. With
  // the found modes R, solves K (R + D) = (R + D) H for D across R, H = Rᵀ K (R + D).
  void apply_asymmetry(const ShiftedFactors& below) {
    result_.of_full_stiffness = false;
    if (held_ != Index(resting_)) return;
    const Eigen::VectorXd mass = (system_.system().mass.array() > 0).cast<double>();
    const Eigen::SparseMatrix<double>& stiffness = system_.weighted().stiffness();
    Matrix full = modes_, h;
    for (int round = 0; round < most_rounds; ++round) {
      const Matrix elastic = stiffness * full;
      h = modes_.transpose() * elastic;
      const Matrix rest = elastic - mass.asDiagonal() * (full * h);
      Matrix correction = across_found(rest);
      below.solve(correction.data(), int(correction.cols()));
      full -= across_found(correction);
    }
    const Matrix elastic = stiffness * full;
    h = modes_.transpose() * elastic;
    // The iteration does not converge if a vibrating mode is as slow as the asymmetry is large.
    if (!((elastic - mass.asDiagonal() * (full * h)).norm() <= system_.rounding())) return;
    result_.of_full_stiffness = true;
    take_over(full, h);
  }

  Matrix across_found(const Matrix& all) const {
    const Matrix shares = modes_.transpose() * all;
    return all - modes_ * shares;
  }

  void take_over(const Matrix& full, const Matrix& h) {
    Matrix shares = Matrix::Identity(held_, held_);
    Eigen::VectorXcd squares = Eigen::VectorXcd::Zero(held_);
    if (h.norm() > system_.rounding()) {
      const Eigen::EigenSolver<Matrix> solver(h);
      shares = solver.pseudoEigenvectors();
      squares = solver.eigenvalues();
    }
    result_.unstable = result_.floppy = 0;
    replacement_ = full * shares;
    for (Index k = 0; k < held_; ++k) {
      replacement_.col(k) /= heavy_part(replacement_.col(k)).norm();
      const bool grows =
          squares[k].real() < -system_.rounding() || std::abs(squares[k].imag()) > system_.rounding();
      // A mode that grows while it oscillates has a complex ω².
      squares_[std::size_t(k)] = grows ? -std::abs(squares[k]) : squares[k].real();
      if (grows) ++result_.unstable;
      if (std::abs(squares[k]) <= system_.rounding()) ++result_.floppy;
    }
  }

  void find_lowest(const ShiftedFactors& below) {
    find_counted(below, [&](double distance) { return number(system_.count_below(distance)) - resting_; });
  }

  void find_near() {
    const std::unique_ptr<ShiftedFactors> factors = system_.factorise(omega() * omega());
    find_counted(*factors, [&](double distance) {
      const double low = std::max(omega() - distance, 0.0), high = omega() + distance;
      const std::size_t first =
          low * low > system_.rounding() ? number(system_.count_below(low * low)) : resting_;
      return number(system_.count_below(high * high)) - first;
    });
  }

  bool is_near() const { return search_.near_hz > 0; }
  double omega() const { return 2 * std::numbers::pi * search_.near_hz; }
  // Distance of a vibrating mode from where modes are wanted: |ω − ω₀| (1/s), or |ω²| (1/s²) for the lowest ones.
  double distance_of(double square) const {
    return is_near() ? std::abs(std::sqrt(std::max(square, 0.0)) - omega()) : std::abs(square);
  }

  // Finds modes nearest to the shift until as many are found as `count_within` counts within a distance.
  template <class Count>
  void find_counted(const ShiftedFactors& factors, const Count& count_within) {
    Index wanted = Index(search_.count) + spare;
    for (int round = 0; round < most_rounds && search_.proceed(); ++round) {
      find(factors, wanted, is_near());
      const Index found = modes_.cols() - held_;
      if (found == 0 || !search_.proceed()) return;
      const auto [distance, within] = last_gap();
      if (within == 0) return;
      search_.on_progress(1, "counting modes");
      const Index counted = Index(count_within(distance));
      result_.complete = counted == within;
      if (counted <= within) return;
      // Modes are found by the distance of ω², in which those below a frequency are nearer than those above it.
      wanted = (is_near() ? 2 : 1) * (counted - within);
    }
  }

  // A distance in a gap between modes, as far out as wanted, and the number of nearer modes.
  std::pair<double, Index> last_gap() const {
    std::vector<double> distances;
    for (std::size_t k = std::size_t(held_); k < squares_.size(); ++k)
      distances.push_back(distance_of(squares_[k]));
    std::sort(distances.begin(), distances.end());
    const std::size_t all = system_.modes() - resting_;
    if (distances.size() == all) return {2 * std::max(distance_of(system_.largest()), omega()), Index(all)};
    for (std::size_t k = std::min(distances.size() - 1, search_.count); k > 0; --k)
      if (const double gap = distances[k] - distances[k - 1]; gap > smallest_gap * (omega() + distances[k]))
        return {distances[k - 1] + 0.5 * gap, Index(k)};
    return {0, 0};
  }

  Matrix random(Index columns) const {
    std::mt19937_64 engine(20261122 + std::uint64_t(modes_.cols()));
    Matrix all(Index(system_.modes()), columns);
    // std::normal_distribution gives other numbers in other libraries.
    for (double& x : all.reshaped()) x = double(engine() >> 11) * 0x1p-52 - 1;
    return all;
  }

  // Unstable and floppy modes and the nearest vibrating ones, in ascending order.
  std::vector<Index> chosen() const {
    std::vector<Index> order(squares_.size());
    std::iota(order.begin(), order.end(), Index(0));
    const auto square = [&](Index k) { return squares_[std::size_t(k)]; };
    std::stable_sort(order.begin() + held_, order.end(),
                     [&](Index a, Index b) { return distance_of(square(a)) < distance_of(square(b)); });
    order.resize(std::min(order.size(), std::size_t(held_) + search_.count));
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return square(a) < square(b); });
    return order;
  }

  FoundModes write() {
    if (replacement_.cols() > 0) modes_.leftCols(held_) = replacement_;
    const std::vector<Index> order = chosen();
    const Matrix weighted = modes_(Eigen::all, order);
    const Index count = weighted.cols();
    result_.square_frequency.resize(count);
    result_.residual.resize(count);
    const Matrix elastic = system_.weighted().stiffness() * weighted;
    const Eigen::VectorXd mass = (system_.system().mass.array() > 0).cast<double>();
    for (Index k = 0; k < count; ++k) {
      const double square = result_.square_frequency[k] = squares_[std::size_t(order[std::size_t(k)])];
      if (square < -system_.rounding()) ++result_.first_floppy;
      if (square <= system_.rounding()) ++result_.first_vibrating;
      const Eigen::VectorXd inertial = square * mass.cwiseProduct(weighted.col(k));
      result_.residual[k] =
          (elastic.col(k) - inertial).norm() / std::max(std::abs(square), system_.rounding());
    }
    result_.shape = system_.weighted().inverse_root().asDiagonal() * weighted;
    return std::move(result_);
  }

  const UndampedSystem& system_;
  const ModeSearch& search_;
  Matrix modes_;                 // one column each
  Matrix replacement_;           // for the first modes: with the full K
  std::vector<double> squares_;  // ω² of each
  std::size_t resting_ = 0;      // number of unstable and floppy modes, by the inertia of K_s
  Index held_ = 0;               // columns of unstable and floppy modes, which come first
  FoundModes result_;
};

}  // namespace

Modes modes_of(const LinearSystem& system) {
  const MassWeighted weighted(system);
  const Eigen::MatrixXd stiffness = weighted.stiffness();
  const Eigen::MatrixXd difference = stiffness - stiffness.transpose();
  const Eigen::MatrixXd symmetric = stiffness - 0.5 * difference;
  std::vector<Index> with_mass, without_mass;
  for (Index i = 0; i < system.mass.size(); ++i) (system.mass[i] > 0 ? with_mass : without_mass).push_back(i);
  // Not the vectors themselves: GCC 12 reports frees of foreign memory where Eigen copies them.
  using Indices = Eigen::Map<const Eigen::Array<Index, Eigen::Dynamic, 1>>;
  const Indices heavy(with_mass.data(), Index(with_mass.size())),
      massless(without_mass.data(), Index(without_mass.size()));
  // Without inertia, 0 = K_mm q_m + K_mh q_h.
  const Eigen::MatrixXd following =
      massless.size() == 0
          ? Eigen::MatrixXd(0, heavy.size())
          : Eigen::MatrixXd(
                -symmetric(massless, massless).eval().fullPivLu().solve(symmetric(massless, heavy).eval()));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(symmetric(heavy, heavy) +
                                                             symmetric(heavy, massless) * following);
  Eigen::MatrixXd shape(system.mass.size(), heavy.size());
  shape(heavy, Eigen::all) = modes.eigenvectors();
  shape(massless, Eigen::all) = following * modes.eigenvectors();
  return {modes.eigenvalues(), weighted.inverse_root().asDiagonal() * shape,
          stiffness.norm() > 0 ? difference.norm() / stiffness.norm() : 0};
}

FoundModes find_modes(const UndampedSystem& system, const ModeSearch& search) {
  return Search(system, search).run();
}

}  // namespace scree::response
