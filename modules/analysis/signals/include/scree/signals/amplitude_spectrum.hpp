#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <scree/plugin/lock_in.hpp>

namespace scree::signals {

// Amplitudes of sines at multiples of a frequency.
struct AmplitudeSpectrum {
  double resolution = 0;          // (Hz) 1 / length of the record
  std::vector<double> amplitude;  // (unit of x) at k * resolution, up to half the sampling rate
  double frequency(std::size_t k) const { return resolution * double(k); }
};

// Removes the straight line through the record, applies a Hann window and returns 2 |X| / (sum of the
// window). A sine at a multiple of the resolution has its amplitude there, one between two multiples at least
// 0.85 of it (scalloping, sinc(1/2) / (1 - 1/4)). step: (s) between values. Throws Error for fewer than 4
// values. One thread at a time.
AmplitudeSpectrum amplitude_spectrum(double step, std::span<const double> values);

// Largest distance of a sample from equal steps, in mean steps. Above 1e-3, use at_equal_steps() before a
// spectrum.
double unevenness(std::span<const double> times);

// As many values at equal steps, on straight lines between the samples. Lowers the amplitude of a sine of
// frequency f by at most (2 pi f h)^2 / 8, h: the longest step.
std::vector<double> at_equal_steps(std::span<const double> times, std::span<const double> values);

// A line in a record of length T with the middle t_m. Let s be the standard error of its phase for a given
// frequency; at t_m it is not correlated with the frequency. The error of the frequency is sqrt(3) s / (pi
// T): with noise of density S near the line, phases of parts of the record, dt long, scatter by s^2 T / dt,
// and the variance of the slope of a line through them is s^2 T / integral of (t - t_m)^2 dt = 12 s^2 / T^2,
// in (rad/s)^2 (Cramer-Rao for white noise). So the phase at t = 0 has
//   phase_error = sqrt(s^2 + (2 pi t_m frequency_error)^2),
// 2 s for a record that begins at 0, and more for one that begins later; s = frequency_error pi T / sqrt(3).
// A line that decays, A exp(-pi f (t - t_0) / Q) sin(2 pi f t + phi), has its amplitude at the first time
// t_0. Its errors are those of a fit of all four numbers in noise of the density near the line. Without
// damping its frequency would be f sqrt(1 + 1 / (4 Q^2)).
struct FoundLine : SpectralLine {
  double frequency_error = 0;             // (Hz) standard error
  double quality = 0, quality_error = 0;  // Q and its standard error; 0 of a line that does not decay
};

// The strongest `most` lines of a record, by amplitude. Candidates are maxima of the spectrum above five
// times the median of the amplitudes on both sides, as far as half the frequency but 6 to 50 of them. White
// noise of a million samples has one with a probability of 3 %, a random walk with about 1 %.
//
// The fit is not bound to multiples of the resolution: frequency, amplitude and phase of each line are fitted
// to the record less all other lines and a drift, a cubic with relaxations where they improve the fit
// (exponential_drift.hpp). A line decays if its rate exceeds five errors. A decay to 1/e in fewer than five
// periods (Q below about 16) has no maximum and is not found. Lines below five errors are left out. Lines of
// fewer than 3 periods, and lines closer than 3 resolutions, are not told apart.
//
// on_progress, if given, receives the share done, 0 to 1.
std::vector<FoundLine> strongest_lines(std::span<const double> times, std::span<const double> values,
                                       const AmplitudeSpectrum& spectrum, std::size_t most,
                                       const std::function<void(double)>& on_progress = {});

}  // namespace scree::signals
