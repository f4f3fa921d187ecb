#pragma once

#include <Eigen/Dense>

namespace scree::signals {

// Covariance over frequency of what modes that no fit tells apart add to a response, and noise. Modes of width w,
// alike and anywhere, make
//   <g(f) conj(g(f'))> = s^2 / (1 + i (f - f') / w):
// they answer after the drive and decay, so that in time g is noise with the variance exp(-2 pi w t) behind t = 0 and
// none before. Here s^2 is 1, in equal parts of widths from a third to three times `width`, times factors of the
// response; the noise is white.
class ModeBackground {
 public:
  ModeBackground(const Eigen::VectorXd& frequencies, const Eigen::VectorXcd& factors, double width);

  // Columns in which background and noise (variance over s^2) are independent and of variance 1.
  Eigen::MatrixXcd whitened(const Eigen::MatrixXcd& columns, double noise) const;
  double log_determinant(double noise) const;  // of the covariance
  double independent(double noise) const;      // values: (sum of variances)^2 / sum of their squares

 private:
  Eigen::VectorXd variances_;
  Eigen::MatrixXcd vectors_;
};

}  // namespace scree::signals
