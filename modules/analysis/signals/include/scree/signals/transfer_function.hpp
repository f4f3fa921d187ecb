#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace scree::signals {

// From a drive x to a response y. X, Y: transforms of segments; S: their means over segments, S_xy = <X* Y>.
struct TransferFunction {
  double resolution = 0;                 // (Hz) 1 / length of a segment; number k is at k * resolution
  std::vector<std::complex<double>> h1;  // (unit of y / unit of x) S_xy / S_xx: unbiased by noise in y
  std::vector<std::complex<double>> h2;  // (the same) S_yy / S_yx: unbiased by noise in x
  std::vector<double> coherence;  // |S_xy|^2 / (S_xx S_yy), 0 to 1; 1 for one segment, whatever the noise
  std::vector<double> error;  // standard error of |h1| / |h1|, and of its phase (rad); NaN for one segment
  std::size_t segments = 0;
  double averages = 0;  // n_d: number of independent segments with the scatter of these, which overlap

  double frequency(std::size_t k) const { return resolution * double(k); }
};

// segment 0: the whole record without window, for a pulse or a chirp that begins and ends at rest, where rest
// is 0.
//   Exact then. A response that has not ended changes H by at most h (sum of |y| after the record) / |X|,
//   h: step.
// segment > 0: number of samples in a segment. Its mean is removed and a Hann window applied; segments
// overlap by
//   half (Welch). For a drive with a flat spectrum h1 is H averaged over the window's |W|^2, whose second moment
//   is 1 / (3 T^2) for segments of length T (integral of w'^2 / integral of w^2 / (2 pi)^2). So its bias is at
//   most max|H''| / (6 T^2), at the peak of a mode of width G (Hz, f0/Q) the share 4 / (3 (G T)^2). Numbers 0 and
//   1 are spoilt by the mean that is removed.
//   error = sqrt((1 - c) / (2 c n_d)), c: coherence (Bendat and Piersol, Random Data, table 9.6), with
//   n_d = n / (1 + 2 sum_j (1 - j/n) r_j^2), r_j: correlation of windows that are j halves apart (Welch 1967);
//   1/6 for neighbours, so that n_d = 0.95 n. The estimate of c is too large by (1 - c)^2 / n_d.
// Where the drive has nothing, h1, h2 and coherence are 0 and the error is infinite.
//
// times: (s) at equal steps. Throws Error for steps that differ by more than 1e-3 of their mean (use
// at_equal_steps() first), arrays of different length, and records shorter than a segment. One thread at a
// time.
TransferFunction transfer_function(std::span<const double> times, std::span<const double> drive,
                                   std::span<const double> response, std::size_t segment);

}  // namespace scree::signals
