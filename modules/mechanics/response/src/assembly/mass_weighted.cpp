#include "assembly/mass_weighted.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::response {

namespace {

void check(const char* name, Eigen::Index given, Eigen::Index needed) {
  if (given != 0 && given != needed)
    throw Error(fmt::format("Drive::{} has {} components; give {} or none", name, given, needed));
}

Eigen::VectorXd inverse_root_of_scale(const LinearSystem& system) {
  const Eigen::VectorXd stiffness = system.stiffness.diagonal().cwiseAbs();
  double largest = 0;
  for (Eigen::Index i = 0; i < stiffness.size(); ++i)
    if (system.mass[i] > 0) largest = std::max(largest, stiffness[i] / system.mass[i]);
  Eigen::VectorXd scale = system.mass;
  for (Eigen::Index i = 0; i < scale.size(); ++i)
    if (scale[i] == 0) scale[i] = stiffness[i] > 0 && largest > 0 ? stiffness[i] / largest : 1;
  return scale.cwiseSqrt().cwiseInverse();
}

}  // namespace

MassWeighted::MassWeighted(const LinearSystem& system)
    : system_(system),
      inverse_root_(inverse_root_of_scale(system)),
      stiffness_(inverse_root_.asDiagonal() * system.stiffness * inverse_root_.asDiagonal()),
      damping_(inverse_root_.asDiagonal() * system.damping * inverse_root_.asDiagonal()),
      mass_(system.mass.size(), system.mass.size()) {
  mass_.setIdentity();
  // Where there is a mass, M/S is 1.
  for (Eigen::Index i = 0; i < system.mass.size(); ++i)
    if (system.mass[i] == 0) mass_.coeffRef(i, i) = 0;
}

ComplexMatrix MassWeighted::dynamic_stiffness(double omega) const {
  const HarmonicRates rates(system_.time_step, omega);
  ComplexMatrix sum = stiffness_.cast<std::complex<double>>();
  if (!has_time_step()) {
    sum += rates.exact * damping_.cast<std::complex<double>>();
  } else {
    sum += damping_.cast<std::complex<double>>() * velocity_rates(rates).asDiagonal();
    ComplexMatrix viscous = mass_.cast<std::complex<double>>();  // has all of the diagonal
    viscous.diagonal() = viscous_terms(rates);
    sum += viscous;
  }
  sum -= rates.square * mass_.cast<std::complex<double>>();
  return sum;
}

Eigen::VectorXcd MassWeighted::velocity_rates(const HarmonicRates& rates) const {
  Eigen::VectorXcd all(system_.mass.size());
  for (Eigen::Index j = 0; j < all.size(); ++j)
    all[j] = system_.mass[j] > 0 ? rates.predicted : rates.backward;
  return all;
}

Eigen::VectorXcd MassWeighted::viscous_terms(const HarmonicRates& rates) const {
  return (inverse_root_.cwiseAbs2().cwiseProduct(system_.wall_viscosity)).cast<std::complex<double>>() *
         (rates.central - rates.predicted);
}

double MassWeighted::nearest_omega(double omega) const {
  return has_time_step() ? std::sqrt(HarmonicRates(system_.time_step, omega).square) : omega;
}

Eigen::VectorXcd MassWeighted::difference(double omega, const Eigen::VectorXcd& q) const {
  const HarmonicRates rates(system_.time_step, omega);
  const Eigen::VectorXcd further =
      velocity_rates(rates).array() - std::complex<double>(0, nearest_omega(omega));
  return damping_ * further.cwiseProduct(q) + viscous_terms(rates).cwiseProduct(q);
}

Eigen::VectorXcd MassWeighted::load(const Drive& drive, double omega) const {
  check("force", drive.force.size(), system_.freedom.size());
  check("walls", drive.walls.size(), system_.wall_stiffness.cols());
  const std::complex<double> i_omega(0, omega);
  Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(system_.freedom.size());
  if (drive.force.size() > 0) sum += drive.force;
  if (drive.walls.size() > 0) {
    if (has_time_step() && (system_.wall_mass * drive.walls).norm() > 0)
      throw Error(
          "a motion that is superposed on a wall with mass has no linear response with the time step of the run; leave it in the limit "
          "of short steps, or drive a wall whose motion is prescribed");
    sum -= system_.wall_stiffness * drive.walls;
    sum -= i_omega * (system_.wall_damping * drive.walls);
    sum += omega * omega * (system_.wall_mass * drive.walls);
  }
  return inverse_root_.asDiagonal() * sum;
}

Eigen::VectorXcd MassWeighted::amplitude(const Eigen::VectorXcd& weighted) const {
  return inverse_root_.asDiagonal() * weighted;
}

}  // namespace scree::response
