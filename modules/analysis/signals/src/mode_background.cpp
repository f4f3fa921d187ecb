#include "mode_background.hpp"

#include <array>
#include <complex>

namespace scree::signals {

namespace {

constexpr std::array widths = {0.35, 0.5, 0.7, 1.0, 1.4, 2.0, 2.8};  // of the modes, over the mean one
constexpr double variance_round_off = 1e-13;

}  // namespace

ModeBackground::ModeBackground(const Eigen::VectorXd& frequencies, const Eigen::VectorXcd& factors,
                               double width) {
  const Eigen::Index count = frequencies.size();
  Eigen::MatrixXcd covariance(count, count);
  for (Eigen::Index row = 0; row < count; ++row)
    for (Eigen::Index column = 0; column <= row; ++column) {
      std::complex<double> sum = 0;
      for (const double of : widths)
        sum += 1.0 / std::complex(1.0, (frequencies[row] - frequencies[column]) / (of * width));
      sum *= factors[row] * std::conj(factors[column]) / double(widths.size());
      covariance(row, column) = sum, covariance(column, row) = std::conj(sum);
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> solver(covariance);
  variances_ = solver.eigenvalues().cwiseMax(0.0).array() + variance_round_off;
  vectors_ = solver.eigenvectors();
}

Eigen::MatrixXcd ModeBackground::whitened(const Eigen::MatrixXcd& columns, double noise) const {
  const Eigen::VectorXd scale = (variances_.array() + noise).rsqrt();
  return scale.asDiagonal() * (vectors_.adjoint() * columns);
}

double ModeBackground::log_determinant(double noise) const {
  return (variances_.array() + noise).log().sum();
}

double ModeBackground::independent(double noise) const {
  const Eigen::ArrayXd variances = variances_.array() + noise;
  return variances.sum() * variances.sum() / variances.square().sum();
}

}  // namespace scree::signals
