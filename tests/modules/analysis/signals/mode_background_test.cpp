#include "mode_background.hpp"

#include <cmath>
#include <complex>

#include <catch2/catch.hpp>

using namespace scree::signals;

namespace {

using Complex = std::complex<double>;
constexpr double background_width = 5, background_noise = 0.01;
const Eigen::Index background_points = 20;

const Eigen::VectorXd frequencies = Eigen::VectorXd::LinSpaced(background_points, 90, 128);

Eigen::VectorXcd factors() {
  return Eigen::VectorXcd(Complex(0, 0.01) * frequencies);  // of velocities
}

// Covariance of background and noise, as the header says it.
Eigen::MatrixXcd covariance() {
  Eigen::MatrixXcd all = background_noise * Eigen::MatrixXcd::Identity(background_points, background_points);
  for (const double share : {0.35, 0.5, 0.7, 1.0, 1.4, 2.0, 2.8})
    for (Eigen::Index j = 0; j < background_points; ++j)
      for (Eigen::Index k = 0; k < background_points; ++k)
        all(j, k) += factors()[j] * std::conj(factors()[k]) / 7.0 /
                     Complex(1, (frequencies[j] - frequencies[k]) / (share * background_width));
  return all;
}

}  // namespace

// Eigenvalues from 0.01 to 10: round-off 1e-13, and 1e-13 that is added to each.
TEST_CASE("whitened columns have the covariance 1", "[mode_background]") {
  const ModeBackground background(frequencies, factors(), background_width);
  const Eigen::MatrixXcd one = Eigen::MatrixXcd::Identity(background_points, background_points);
  const Eigen::MatrixXcd basis = background.whitened(one, background_noise);
  CHECK((basis * covariance() * basis.adjoint() - one).norm() < 1e-9);
  CHECK(background.log_determinant(background_noise) ==
        Approx(std::log(std::abs(covariance().determinant()))).epsilon(1e-9));
  const Eigen::MatrixXcd squared = covariance() * covariance();
  CHECK(background.independent(background_noise) ==
        Approx(std::norm(covariance().trace()) / squared.trace().real()).epsilon(1e-9));
}

TEST_CASE("far narrower than the distance of frequencies, a background is as independent as noise",
          "[mode_background]") {
  const Eigen::VectorXcd ones = Eigen::VectorXcd::Ones(background_points);
  CHECK(ModeBackground(frequencies, ones, 1e-4).independent(0) ==
        Approx(double(background_points)).epsilon(1e-6));
  CHECK(ModeBackground(frequencies, ones, 1e6).independent(0) == Approx(1).epsilon(1e-6));
}
