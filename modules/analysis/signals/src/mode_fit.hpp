#pragma once

#include "scree/signals/peaks.hpp"

#include <complex>
#include <cstddef>
#include <vector>

#include <Eigen/Dense>

namespace scree::signals {

// A response over frequency. Of amplitudes alone, the values have no imaginary part.
struct ResponseSpectrum {
  std::vector<double> frequencies;  // (Hz)
  std::vector<std::complex<double>> values;
  bool only_amplitudes = false;
  int derivative = 0;  // in time, of the quantity whose response is a sum of poles

  // (i f)^derivative. The (2 pi)^derivative of the derivative is part of the strengths.
  std::complex<double> factor(double frequency) const {
    return std::pow(std::complex<double>(0, frequency), derivative);
  }
};

// R / (frequency^2 - f^2 + i f width), times the factor of the response.
struct Pole {
  double frequency, width;  // (Hz)
  // R. Of amplitudes: |R|^2 + i b, b the interference with the other poles and the background
  // (mode_model.hpp).
  std::complex<double> strength{};
};

// A fit of poles on a linear background.
struct ModeFit {
  std::vector<Pole> poles;
  // Of frequency, width and both parts of the strength of each pole, for white residuals; NaN without spare
  // points.
  Eigen::MatrixXd covariance;
  double residual = 0;     // sum of squares
  double criterion = 0;    // Akaike's, corrected for few points
  double correlation = 0;  // of neighbouring residuals; within 1/sqrt(points) of 0 if only noise is left
  // Factor by which the covariance is too small where residuals are correlated, 1 if they are white: points
  // less parameters, over independent points less parameters (or over 1, if that is larger).
  double excess = 1;
  bool converged = false;
};

// Levenberg-Marquardt, from frequency and width of each pole, with a background of degree 1 or 2.
ModeFit fit_modes(const ResponseSpectrum& response, const std::vector<Pole>& start, int degree = 1);

// The numbers of one pole of a fit, with their errors.
FittedMode mode_of(const ModeFit& fit, std::size_t number, const ResponseSpectrum& response);

// Whether a pole shows beside the others of its fit. Over its width w it changes the response by its height
// A, and the others change it by about w |dH_others/df|. Below a quarter of that it only bends their
// background.
bool stands_out(const ModeFit& fit, std::size_t number, bool only_amplitudes);

}  // namespace scree::signals
