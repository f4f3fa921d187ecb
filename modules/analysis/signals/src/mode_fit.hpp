#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include <Eigen/Dense>

namespace scree::signals {

// A response over frequency; amplitudes have no imaginary parts.
struct Response {
  std::vector<double> frequencies;  // (Hz)
  std::vector<std::complex<double>> values;
  bool only_amplitudes = false;
  int derivative = 0;  // in time, of what responds as a sum of poles

  // By which this derivative multiplies a response, (i f)^derivative; (2 pi)^derivative is in the strengths.
  std::complex<double> factor(double frequency) const {
    return std::pow(std::complex<double>(0, frequency), derivative);
  }
};

// A pole: R / (frequency^2 - f^2 + i f width), times the factor of the response; of amplitudes, |R|^2 and what mixes it with the rest (mode_model.hpp).
struct Pole {
  double frequency, width;
  std::complex<double> strength{};  // R, or |R|^2 + i b
};

// A fit of poles and a linear background.
struct ModeFit {
  std::vector<Pole> poles;
  Eigen::MatrixXd
      covariance;  // for white residuals, of frequency, width and the parts of strength of each pole; NaN without spare points
  double residual = 0;   // sum of squares
  double criterion = 0;  // Akaike's, corrected
  double correlation =
      0;  // of residuals with their neighbours: 0 within 1/sqrt(points) if only noise is left
  // By which the covariance is too small where residuals are correlated: as many numbers as there are, less the parameters, over as many as
  // are independent, less these, or over 1; 1 for white residuals.
  double excess = 1;
  bool converged = false;
};

// Levenberg-Marquardt from poles of which frequency and width are given, with a background of degree 1 or 2.
ModeFit fit_modes(const Response& response, const std::vector<Pole>& start, int degree = 1);

}  // namespace scree::signals
