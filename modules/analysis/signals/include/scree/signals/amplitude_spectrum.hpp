#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <scree/signals/lock_in.hpp>

namespace scree::signals {

// Amplitudes of sines at multiples of a frequency.
struct AmplitudeSpectrum {
  double resolution = 0;          // (Hz) 1 / length of the record
  std::vector<double> amplitude;  // (unit of x) at k * resolution, up to half the sampling rate
  double frequency(std::size_t k) const { return resolution * double(k); }
};

// The straight line through the record is removed and a Hann window applied; 2 |X| / sum of the window. A sine at a multiple
// of the resolution has its amplitude there, one between two of them at least 0.85 of it (scalloping, sinc(1/2) / (1 - 1/4)).
// step: (s) between values. Throws Error for fewer than 4 values. Not for several threads at once.
AmplitudeSpectrum amplitude_spectrum(double step, std::span<const double> values);

// Largest distance of a sample from equal steps, in units of the mean step. Above 1e-3, a spectrum is one of at_equal_steps().
double unevenness(std::span<const double> times);

// Values at equal steps by straight lines between samples, as many as there are. This lowers the amplitude of a sine of
// frequency f by at most (2 pi f h)^2 / 8, h: the longest step.
std::vector<double> at_equal_steps(std::span<const double> times, std::span<const double> values);

// A line that was found in a record, of length T about the time t_m. For a given frequency, let the phase have the standard error s; at
// t_m it is not correlated with the frequency. The error of the frequency is sqrt(3) s / (pi T): with noise of density S near the line,
// phases of parts of the record, dt long, scatter by s^2 T / dt, and the variance of the slope of a line through them is
// s^2 T / integral of (t - t_m)^2 dt = 12 s^2 / T^2, in (rad/s)^2 (Cramer-Rao for white noise). So the phase at t = 0 has
//   phase_error = sqrt(s^2 + (2 pi t_m frequency_error)^2),
// 2 s for a record that begins at 0, and more for one that begins later; s = frequency_error pi T / sqrt(3).
// A line that decays, A exp(-pi f (t - t_0) / Q) sin(2 pi f t + phi), has its amplitude at the first time t_0; its
// errors are those of the fit of all four numbers in noise of the density near the line. The frequency without
// damping would be f sqrt(1 + 1 / (4 Q^2)).
struct FoundLine : SpectralLine {
  double frequency_error = 0;             // (Hz) standard error
  double quality = 0, quality_error = 0;  // Q and its standard error; 0 of a line that does not decay
};

// The strongest `most` lines of a record, by amplitude. Candidates are maxima of the spectrum above five times the median of the
// amplitudes on both sides, as far as half the frequency but 6 to 50 of them: white noise of a million samples has one with a
// probability of 3 %, a random walk with about 1 %. The frequency of each is fitted with its amplitude and phase, in the record
// less all other lines and a drift: a cubic, and a relaxation (a + b t) exp(-r t) where that lowers what is left
// (relaxations at more rates where that does). So it is not bound to multiples of the resolution. It decays if the
// rate, fitted too, is above five of its errors; a decay to 1/e in fewer than five periods (Q below some 16) shows no
// maximum and is not found. A line below five of its errors is none. Lines of fewer than 3 periods and lines closer
// than 3 resolutions are not told apart. on_progress, if given, receives the share that is done.
std::vector<FoundLine> strongest_lines(std::span<const double> times, std::span<const double> values,
                                       const AmplitudeSpectrum& spectrum, std::size_t most,
                                       const std::function<void(double)>& on_progress = {});

}  // namespace scree::signals
