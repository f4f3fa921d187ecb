#include "mass_weighted.hpp"

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::response {

namespace {

void check(const char* name, Eigen::Index given, Eigen::Index needed) {
  if (given != 0 && given != needed)
    throw Error(fmt::format("Drive::{} has {} components; give {} or none", name, given, needed));
}

}  // namespace

MassWeighted::MassWeighted(const LinearSystem& system)
    : system_(system),
      inverse_root_(system.mass.cwiseSqrt().cwiseInverse()),
      stiffness_(inverse_root_.asDiagonal() * system.stiffness * inverse_root_.asDiagonal()),
      damping_(inverse_root_.asDiagonal() * system.damping * inverse_root_.asDiagonal()),
      identity_(system.mass.size(), system.mass.size()) {
  identity_.setIdentity();
}

ComplexMatrix MassWeighted::dynamic_stiffness(double omega) const {
  const std::complex<double> i_omega(0, omega);
  ComplexMatrix sum = stiffness_.cast<std::complex<double>>();
  sum += i_omega * damping_.cast<std::complex<double>>();
  sum -= omega * omega * identity_.cast<std::complex<double>>();
  return sum;
}

Eigen::VectorXcd MassWeighted::load(const Drive& drive, double omega) const {
  check("force", drive.force.size(), system_.freedom.size());
  check("walls", drive.walls.size(), system_.wall_stiffness.cols());
  const std::complex<double> i_omega(0, omega);
  Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(system_.freedom.size());
  if (drive.force.size() > 0) sum += drive.force;
  if (drive.walls.size() > 0) {
    sum -= system_.wall_stiffness * drive.walls;
    sum -= i_omega * (system_.wall_damping * drive.walls);
  }
  return inverse_root_.asDiagonal() * sum;
}

Eigen::VectorXcd MassWeighted::amplitude(const Eigen::VectorXcd& weighted) const {
  return inverse_root_.asDiagonal() * weighted;
}

}  // namespace scree::response
