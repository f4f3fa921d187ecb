#include "assembly/mass_weighted.hpp"
#include "band/band_library.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include <scree/response/undamped_system.hpp>

namespace scree::response {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

// Relative change of ω² by which a count may be moved. Less than the gaps in which found_modes.cpp counts.
constexpr double resolution = 1e-8;

Eigen::VectorXd row_sums(const Sparse& matrix) {
  return matrix.cwiseAbs() * Eigen::VectorXd::Ones(matrix.cols());
}

}  // namespace

UndampedSystem::UndampedSystem(const LinearSystem& system)
    : system_(system), weighted_(std::make_unique<MassWeighted>(system)) {
  const Sparse& stiffness = weighted_->stiffness();
  const Sparse transposed = stiffness.transpose();
  // Stores both halves and the whole diagonal, from which shifts are subtracted.
  Sparse diagonal(stiffness.rows(), stiffness.rows());
  diagonal.setIdentity();
  symmetric_ = 0.5 * (stiffness + transposed) + 0.0 * diagonal;
  const double norm = stiffness.norm();
  asymmetry_ = norm > 0 ? Sparse(stiffness - transposed).norm() / norm : 0;
  std::vector<Eigen::Index> massless;
  for (Eigen::Index i = 0; i < system.mass.size(); ++i) (system.mass[i] > 0 ? heavy_ : massless).push_back(i);
  largest_ = row_sums(symmetric_).maxCoeff();
  if (!massless.empty()) {
    const Eigen::Index count = Eigen::Index(massless.size());
    const Eigen::MatrixXd part =
        Eigen::MatrixXd::NullaryExpr(count, count, [&](Eigen::Index r, Eigen::Index c) {
          return symmetric_.coeff(massless[std::size_t(r)], massless[std::size_t(c)]);
        });
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> own(part);
    negative_massless_ = std::size_t((own.eigenvalues().array() < 0).count());
  }
  const Eigen::VectorXd mass = (system.mass.array() > 0).cast<double>();
  backend_ = band_library().create_shifts(view_of(symmetric_), mass.data());
}

UndampedSystem::~UndampedSystem() = default;

std::unique_ptr<ShiftedFactors> UndampedSystem::factorise(double square_frequency) const {
  return backend_->factorise(square_frequency);
}

ModeCount UndampedSystem::count_below(double square_frequency) const {
  return count_below(*factorise(square_frequency));
}

ModeCount UndampedSystem::count_below(const ShiftedFactors& factors) const {
  const std::size_t negative = std::max(std::size_t(factors.negative()), negative_massless_);
  const double allowed = std::max(rounding(), resolution * std::abs(factors.shift()));
  return {negative - negative_massless_, !factors.has_null_pivot() && factors.margin() <= allowed};
}

std::string uncertain_warning(const std::string& which) {
  return which +
         " may be wrong: round-off of the factorisation of K moves modes across the frequency of the count; leave "
         "bodies with few contacts out (--fewest-contacts), or count at other frequencies";
}

}  // namespace scree::response
