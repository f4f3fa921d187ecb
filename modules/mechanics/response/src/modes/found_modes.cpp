#include "assembly/mass_weighted.hpp"
#include "band/backend/band_backend.hpp"
#include "modes/mode_span.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <Eigen/Eigenvalues>

#include <scree/response/found_modes.hpp>

namespace scree::response {

namespace {

using Matrix = Eigen::MatrixXd;
using Index = Eigen::Index;

constexpr std::size_t most_unstable = 200;  // modes whose shapes are computed
// Smallest relative gap between neighbouring ω² in which modes can be counted.
constexpr double smallest_gap = 1e-7;
constexpr int most_rounds = 6;
constexpr double round_off = 1e-13;  // an asymmetry below this is round-off

// The search, in the coordinates √M q of all degrees of freedom.
class Search {
 public:
  Search(const UndampedSystem& system, const ModeSearch& search)
      : system_(system), search_(search), found_(system, search) {}

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
    found_.find(*below, Index(result_.floppy), true);
    find_unstable();
    held_ = found_.size();
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
    found_.find(*factors, Index(result_.unstable), true);
  }

  // Turns modes of the symmetric part with ω² <= 0 into modes of the full K: bodies that turn freely between
  // two contacts are floppy with the full K, but have an ω² below 0, of second order in the asymmetry, with
  // its symmetric part. With the found modes R, solves K (R + D) = (R + D) H for D across R, H = Rᵀ K (R +
  // D).
  void apply_asymmetry(const ShiftedFactors& below) {
    result_.of_full_stiffness = false;
    if (held_ != Index(resting_)) return;
    const Eigen::VectorXd mass = (system_.system().mass.array() > 0).cast<double>();
    const Eigen::SparseMatrix<double>& stiffness = system_.weighted().stiffness();
    const Matrix& modes = found_.modes();
    Matrix full = modes, h;
    for (int round = 0; round < most_rounds; ++round) {
      const Matrix elastic = stiffness * full;
      h = modes.transpose() * elastic;
      const Matrix rest = elastic - mass.asDiagonal() * (full * h);
      Matrix correction = found_.across(rest);
      below.solve(correction.data(), int(correction.cols()));
      full -= found_.across(correction);
    }
    const Matrix elastic = stiffness * full;
    h = modes.transpose() * elastic;
    // The iteration does not converge if a vibrating mode is as slow as the asymmetry is large.
    if (!((elastic - mass.asDiagonal() * (full * h)).norm() <= system_.rounding())) return;
    result_.of_full_stiffness = true;
    take_over(full, h);
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
      replacement_.col(k) /= found_.heavy_part(replacement_.col(k)).norm();
      const bool grows =
          squares[k].real() < -system_.rounding() || std::abs(squares[k].imag()) > system_.rounding();
      // A mode that grows while it oscillates has a complex ω².
      replacement_squares_.push_back(grows ? -std::abs(squares[k]) : squares[k].real());
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

  double square_of(Index k) const {
    const auto at = std::size_t(k);
    return at < replacement_squares_.size() ? replacement_squares_[at] : found_.squares()[at];
  }

  bool is_near() const { return search_.near_hz > 0; }
  double omega() const { return 2 * std::numbers::pi * search_.near_hz; }
  // Distance of a vibrating mode from where modes are wanted: |ω − ω₀| (1/s), or |ω²| (1/s²) for the lowest
  // ones.
  double distance_of(double square) const {
    return is_near() ? std::abs(std::sqrt(std::max(square, 0.0)) - omega()) : std::abs(square);
  }

  // Finds modes nearest to the shift until as many are found as `count_within` counts within a distance.
  template <class Count>
  void find_counted(const ShiftedFactors& factors, const Count& count_within) {
    Index wanted = Index(search_.count) + spare_modes;
    for (int round = 0; round < most_rounds && search_.proceed(); ++round) {
      found_.find(factors, wanted, is_near());
      const Index found = found_.size() - held_;
      if (found == 0 || !search_.proceed()) return;
      const auto [distance, within] = last_gap();
      if (within == 0) return;
      search_.on_progress(1, "counting modes");
      const Index counted = Index(count_within(distance));
      result_.complete = counted == within;
      if (counted <= within) return;
      // Modes are found by the distance of ω², in which those below a frequency are nearer than those above
      // it.
      wanted = (is_near() ? 2 : 1) * (counted - within);
    }
  }

  // A distance in a gap between modes, as far out as wanted, and the number of nearer modes.
  std::pair<double, Index> last_gap() const {
    std::vector<double> distances;
    for (Index k = held_; k < found_.size(); ++k) distances.push_back(distance_of(square_of(k)));
    std::sort(distances.begin(), distances.end());
    const std::size_t all = system_.modes() - resting_;
    if (distances.size() == all) return {2 * std::max(distance_of(system_.largest()), omega()), Index(all)};
    for (std::size_t k = std::min(distances.size() - 1, search_.count); k > 0; --k)
      if (const double gap = distances[k] - distances[k - 1]; gap > smallest_gap * (omega() + distances[k]))
        return {distances[k - 1] + 0.5 * gap, Index(k)};
    return {0, 0};
  }

  // Unstable and floppy modes and the nearest vibrating ones, in ascending order.
  std::vector<Index> chosen() const {
    std::vector<Index> order(std::size_t(found_.size()));
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin() + held_, order.end(), [this](Index a, Index b) {
      return distance_of(square_of(a)) < distance_of(square_of(b));
    });
    order.resize(std::min(order.size(), std::size_t(held_) + search_.count));
    std::stable_sort(order.begin(), order.end(),
                     [this](Index a, Index b) { return square_of(a) < square_of(b); });
    return order;
  }

  FoundModes write() {
    Matrix modes = found_.modes();
    if (replacement_.cols() > 0) modes.leftCols(held_) = replacement_;
    const std::vector<Index> order = chosen();
    const Matrix weighted = modes(Eigen::all, order);
    const Index count = weighted.cols();
    result_.square_frequency.resize(count);
    result_.residual.resize(count);
    const Matrix elastic = system_.weighted().stiffness() * weighted;
    const Eigen::VectorXd mass = (system_.system().mass.array() > 0).cast<double>();
    for (Index k = 0; k < count; ++k) {
      const double square = result_.square_frequency[k] = square_of(order[std::size_t(k)]);
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
  ModeSpan found_;
  // Of the first modes: with the full K, one column each, and their ω².
  Matrix replacement_;
  std::vector<double> replacement_squares_;
  std::size_t resting_ = 0;  // number of unstable and floppy modes, by the inertia of K_s
  Index held_ = 0;           // columns of unstable and floppy modes, which come first
  FoundModes result_;
};

}  // namespace

FoundModes find_modes(const UndampedSystem& system, const ModeSearch& search) {
  return Search(system, search).run();
}

}  // namespace scree::response
