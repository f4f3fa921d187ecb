#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <scree/spectrum/lock_in.hpp>

namespace scree::spectrum {

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

// A line that was found in a record.
struct FoundLine : Line {
  double frequency_error =
      0;  // (Hz) standard error, sqrt(3)/(pi T) times that of the phase (Cramer-Rao for the same noise)
};

// The strongest `most` lines of a record, by amplitude. Candidates are maxima of the spectrum above five times the median of the
// amplitudes on both sides, as far as half the frequency but 6 to 50 of them: white noise of a million samples has one with a
// probability of 3 %, a random walk with about 1 %. The frequency of each is that for which a lock-in finds the same phase in both halves of the record, so
// that it is not bound to multiples of the resolution. A line below five of its errors is none. Lines of fewer than 3 periods
// and lines closer than 3 resolutions are not told apart.
std::vector<FoundLine> strongest_lines(std::span<const double> times, std::span<const double> values,
                                       const AmplitudeSpectrum& spectrum, std::size_t most);

}  // namespace scree::spectrum
