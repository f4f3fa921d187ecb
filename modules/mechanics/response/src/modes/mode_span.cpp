#include "modes/mode_span.hpp"

#include "band/backend/band_backend.hpp"
#include "modes/krylov.hpp"

#include <algorithm>
#include <cstdint>
#include <random>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace scree::response {

namespace {

using Matrix = Eigen::MatrixXd;
using Index = Eigen::Index;

constexpr Index narrow_block = 8, widest_block = 100;
constexpr int most_span_rounds = 6;

}  // namespace

ModeSpan::ModeSpan(const UndampedSystem& system, const ModeSearch& search)
    : system_(system), search_(search), modes_(system.symmetric_stiffness().rows(), 0) {}

void ModeSpan::find(const ShiftedFactors& factors, Index wanted, bool both_sides) {
  const Index target = modes_.cols() + std::min(wanted, Index(system_.modes()) - modes_.cols());
  for (int round = 0; modes_.cols() < target && round < most_span_rounds && search_.proceed(); ++round) {
    const Index before = modes_.cols(), missing = target - before;
    const Index block = std::min({std::max(narrow_block, std::min(missing + spare_modes, widest_block)),
                                  Index(system_.modes()) - before});
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

void ModeSpan::add(Matrix vectors) {
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

Matrix ModeSpan::invert(const ShiftedFactors& factors, const Matrix& heavy) const {
  Matrix x = without_found(heavy);
  x = heavy_part(solved(factors, x));
  return without_found(x);
}

Matrix ModeSpan::solved(const ShiftedFactors& factors, const Matrix& heavy) const {
  Matrix all = Matrix::Zero(modes_.rows(), heavy.cols());
  all(system_.heavy(), Eigen::all) = heavy;
  factors.solve(all.data(), int(all.cols()));
  return all;
}

Matrix ModeSpan::heavy_part(const Matrix& all) const { return all(system_.heavy(), Eigen::all); }

Matrix ModeSpan::without_found(const Matrix& heavy) const {
  if (modes_.cols() == 0) return heavy;
  const Matrix found = heavy_part(modes_);
  Matrix rest = heavy;
  const Matrix shares = found.transpose() * rest;
  rest.noalias() -= found * shares;
  return rest;
}

Matrix ModeSpan::random(Index columns) const {
  std::mt19937_64 engine(20261122 + std::uint64_t(modes_.cols()));
  Matrix all(Index(system_.modes()), columns);
  // std::normal_distribution gives other numbers in other libraries.
  for (double& x : all.reshaped()) x = double(engine() >> 11) * 0x1p-52 - 1;
  return all;
}

Matrix ModeSpan::across(const Matrix& all) const {
  const Matrix shares = modes_.transpose() * all;
  return all - modes_ * shares;
}

}  // namespace scree::response
