#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace scree::signals {

// A mode that was fitted to a response over frequency:
//   H(f) = (i f)^derivative (R / (f0^2 - f^2 + i f w) + c0 + c1 (f - f_middle)),   R, c0, c1 complex.
// Errors are standard deviations: over the fit, the noise, and a background of weak modes; NaN without spare
// points.
struct FittedMode {
  double frequency = 0, frequency_error = 0;  // f0 (Hz), of the mode without damping
  double width = 0, width_error = 0;          // w (Hz), where the energy is above half its maximum
  double quality = 0, quality_error = 0;      // Q = f0 / w
  // (unit of H) height of this mode alone at f0: |R| / (f0 w) f0^derivative
  double amplitude = 0, amplitude_error = 0;
  // (rad) of i^derivative R, in (-pi, pi]; 0 of amplitudes. 0: the response follows a slow drive; pi/2: its
  // velocity does.
  double phase = 0;
  std::size_t together = 1;  // poles of the fit: this one, its neighbours and those of the background
  std::size_t points = 0;    // frequencies of the fit
};

// Fits the peaks of a response and returns their modes by frequency. A peak rises above both sides by 8 times
// the noise, of amplitudes by 10 times. Modes that others hide or that are not known to half their height or
// width are left out. NOTES.md has the method and how often the errors hold.
//
// frequencies: (Hz) increasing, above 0, at least four in the width of a mode, better ten. derivative: in
// time, of the response to a displacement: 0 for displacements, 1 for velocities, 2 for accelerations. Throws
// Error for arrays of different length, numbers that are not finite and fewer than 16 frequencies.
std::vector<FittedMode> fit_peaks(std::span<const double> frequencies,
                                  std::span<const std::complex<double>> response, int derivative = 0);

// The same from amplitudes |H| alone, without phases.
std::vector<FittedMode> fit_peaks(std::span<const double> frequencies, std::span<const double> amplitudes,
                                  int derivative = 0);

// Distance (Hz) from a maximum of |H|, at index `top`, to where |H| has fallen by a factor of sqrt(2),
// towards lower (direction -1) or higher (1) frequencies; infinite if it does not within the band.
double half_width(std::span<const double> frequencies, std::span<const std::complex<double>> response,
                  std::size_t top, int direction);

}  // namespace scree::signals
