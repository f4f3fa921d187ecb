#pragma once

#include "mode_fit.hpp"

#include <Eigen/Dense>

namespace scree::signals {

// Residuals of a response against poles and a background, and their derivatives. With q = f0^2 - f^2, u from
// -1 to 1:
//   complex:    H = sum of R / (q + i f w) + c0 + c1 u;                  parameters f0, w, Re R, Im R of a pole
//   amplitudes: |H|^2 = sum of (a + b q) / (q^2 + f^2 w^2) + c0 + c1 u;  parameters f0, w, a, b; c0 and c1 real
// times ResponseSpectrum::factor, or its square for amplitudes. The last parameters are Re c0, Im c0, Re c1,
// Im c1. b is the interference of a mode with the others and the background.
class ModeModel {
 public:
  // A background of degree 2 has c2 u^2 too.
  ModeModel(const ResponseSpectrum& response, std::size_t poles, int degree = 1);

  Eigen::Index parameters() const { return of_poles() + background(); }
  // Parameters of the poles, which come first, and of the background.
  Eigen::Index of_poles() const { return Eigen::Index(4 * poles_); }
  Eigen::Index background() const { return 2 * (degree_ + 1); }
  // Parameters that are not fixed, and real residuals.
  Eigen::Index free_parameters() const {
    return parameters() - (response_.only_amplitudes ? background() / 2 : 0);
  }
  Eigen::Index residuals() const;

  // The strengths and the background that fit best, for given frequencies and widths.
  Eigen::VectorXd start(const std::vector<Pole>& poles) const;
  // Residuals, NaN where |H|^2 would be negative. derivatives: filled too unless null, 0 for fixed
  // parameters.
  Eigen::VectorXd evaluate(const Eigen::VectorXd& at, Eigen::MatrixXd* derivatives) const;

 private:
  // The value at a frequency, H or |H|^2, and its derivatives by all parameters.
  std::complex<double> value(const Eigen::VectorXd& at, double frequency,
                             Eigen::RowVectorXcd& derivative) const;
  void add_pole(const double* pole, double frequency, std::complex<double>& sum,
                Eigen::Ref<Eigen::RowVectorXcd> derivative) const;
  double scaled(double frequency) const { return (frequency - middle_) / half_range_; }

  const ResponseSpectrum& response_;
  std::size_t poles_;
  Eigen::Index degree_;  // of the background
  double middle_, half_range_;
};

}  // namespace scree::signals
