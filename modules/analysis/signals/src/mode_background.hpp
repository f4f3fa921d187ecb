#pragma once

#include <Eigen/Dense>

namespace scree::signals {

// Covariance over frequency of noise and of modes that no fit tells apart. Modes of width w, alike and
// anywhere, add
//   <g(f) conj(g(f'))> = s^2 / (1 + i (f - f') / w):
// they answer after the drive and decay, so that g in time is noise of variance exp(-2 pi w t) from t = 0 on.
// Here s^2 is 1, in equal parts of widths from a third to three times `width`, times factors of the response.
// The noise is white.
class ModeBackground {
 public:
  ModeBackground(const Eigen::VectorXd& frequencies, const Eigen::VectorXcd& factors, double width);

  // The columns in a basis in which background plus noise is independent and of variance 1. noise: variance /
  // s^2.
  Eigen::MatrixXcd whitened(const Eigen::MatrixXcd& columns, double noise) const;
  double log_determinant(double noise) const;  // of the covariance
  double independent(double noise) const;  // number of values: (sum of variances)^2 / sum of their squares

 private:
  Eigen::VectorXd variances_;
  Eigen::MatrixXcd vectors_;
};

}  // namespace scree::signals
