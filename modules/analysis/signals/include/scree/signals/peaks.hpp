#pragma once

#include <complex>
#include <span>
#include <vector>

namespace scree::signals {

// A mode in a response over frequency, from a fit of
//   H(f) = R / (f0^2 - f^2 + i f w) + c0 + c1 (f - f_middle),   R, c0, c1 complex.
// or, of a velocity (derivative 1) or an acceleration (2) in response to a displacement, (i f)^derivative times that: the numerator of a
// pole is then no constant. Without this, c0 and c1 take all of it but the share 0.4 / Q^4 in the f0 of a velocity and 0.8 / Q^4 in the
// Q of an acceleration (both 0.1 % at Q = 5).
// Errors are standard deviations of the likelihood over all that is not known: strengths, noise, and a background of modes
// that no fit tells apart, of any strength and of 0.25 to 2 widths w; over the choices of poles that are fitted beside
// this one, too. So they hold for noise as for disorder (README.md has the shares). Of amplitudes, and with too few
// frequencies, they are standard errors: the covariance of the fit, scaled by its residual over as many numbers as are
// independent by the correlation of residuals (white: all of them); NaN without spare points.
struct Mode {
  double frequency = 0, frequency_error = 0;  // f0 (Hz), of the mode without damping
  double width = 0, width_error = 0;          // w (Hz), where the energy is above half its maximum
  double quality = 0, quality_error = 0;      // Q = f0 / w
  double amplitude = 0,
         amplitude_error = 0;  // (unit of H) height of this mode alone at f0: |R| / (f0 w) f0^derivative
  // (rad) of i^derivative R, in (-pi, pi]: 0 if the response follows a slow drive, pi/2 if its velocity does; 0 from amplitudes
  double phase = 0;
  std::size_t together = 1;  // poles of the fit, this one and those of the background included
  std::size_t points = 0;    // frequencies of the fit
};

// Modes within a band, by frequency. A mode begins with a maximum of |H| that rises above both sides by 8 times the noise (10 times, of
// amplitudes): the rms, from the median of third differences of the 50 values on each side, which a smooth response
// hardly has. White noise of 1e5 values passes with a probability below 1e-3. Maxima at the ends of the band are none.
//
// The fit takes three widths on each side; modes whose ranges overlap are fitted together, and the flanks of all others are
// subtracted (not from amplitudes). Broad modes join to one range over much of the band; so each mode is estimated once more within six
// of its widths, less the flanks of the modes beyond (not from amplitudes, whose modes depend on the band). Where residuals are correlated, another pole is added, up to six, where it
// lowers Akaike's criterion (corrected for few points) by more than 10, is within the range and is above five of its
// standard errors: two modes half a width apart are told apart where noise allows. What is no sum of modes, for example a response
// through a window, can need a pole more than there are modes: choose a resolution of a tenth of the width or better.
// A mode with fewer than 4 frequencies in its width is not reported. Neither is a pole that the others of its fit hide: over its width
// w, it changes the response by its height A, they by about w |dH_others/df|; below a quarter of that it only bends their background, as
// transverse modes do that disorder couples to a longitudinal drive, or flanks beyond the fit. Such poles are kept in the fit. Of two
// modes alike, half a width apart, the ratio is 1; of two poles at least one is reported. Nor is a mode whose height or
// width is not known to half of it, or, not from amplitudes, whose height is more than twice the largest response within
// its width: poles beside it would take most of it away.
//
// frequencies: (Hz) increasing, above 0, where the response is flat with distances as large as elsewhere or larger. Throws Error for arrays of different length, numbers
// that are not finite and fewer than 16 frequencies.
std::vector<Mode> find_modes(std::span<const double> frequencies,
                             std::span<const std::complex<double>> response, int derivative = 0);

// The same from |H|, by a fit of |H|^2 = (a + b (f0^2 - f^2)) / |f0^2 - f^2 + i f w|^2 + c0 + c1 (f - f_middle), all real: exact for
// a mode alone; of its interference with a background, b takes all but the part (w/f0)^2. Noise that is not small against
// |H| raises amplitudes.
std::vector<Mode> find_modes(std::span<const double> frequencies, std::span<const double> amplitudes,
                             int derivative = 0);

// Distance (Hz) from a maximum of |H|, at the index `top`, to where it has fallen to its root half, on the side of lower (direction -1) or
// higher (1) frequencies; infinite if it does not within the band.
double half_width(std::span<const double> frequencies, std::span<const std::complex<double>> response,
                  std::size_t top, int direction);

}  // namespace scree::signals
