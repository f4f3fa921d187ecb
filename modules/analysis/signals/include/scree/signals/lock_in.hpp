#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace scree::signals {

// A lock-in fits, by least squares and sample by sample,
//   x(t) = drift + sum over h = 1..harmonics of A_h sin(2 pi h f (t - origin) + phi_h).
// Sample times may have any distances, if they determine the terms.
//
// drift: a polynomial of degree d (Legendre polynomials of 2 (t - t0) / duration - 1), fitted with the rest, so that such a
// drift changes no amplitude. What a polynomial leaves of another drift, r(t), changes A_1 by at most
//   (2 max|r| + V(r)) / (pi f T),   T: length of the record, V: total variation of r,
// from (2/T) |integral of r exp(-2 pi i f t)| by parts, to first order in 1 / (f T); any polynomial may be taken for the bound.
//
// Errors: standard errors of the noise that the record has near h f. Columns at h f ± k/T are fitted behind the model; the
// energy that they take from the residual, per degree of freedom, is the noise per sample near h f, in the same
// metric in which the covariance of the fit is scaled. k = 1 is left out, since the window of the record (and a slightly
// different frequency) puts there what belongs to the line; k up to 6 is near enough for noise that follows 1/f: its mean over
// f ± k/T exceeds that at f by 18 / (f T)^2. Offsets beyond 0.4 f are not used: below f T = 5 there are none, and the
// noise is taken from the whole residual, as if it were white.
//
// An amplitude A with the error s is found as sqrt(A^2 + s^2) in the mean: one of few errors says that there may be none.
struct LockInOptions {
  double frequency = 0;  // f (Hz) above 0
  double duration = 0;   // (s) above 0: expected length of the record; scales drift and the distance of k
  int harmonics = 3;     // 1 to 3
  int drift_degree = 1;  // 0 to 3
  double origin = 0;     // (s) to which phases refer
};

struct Line {
  double frequency = 0;        // (Hz)
  double amplitude = 0;        // (unit of x) 0 or more
  double phase = 0;            // (rad) of a sine, in (-pi, pi]
  double amplitude_error = 0;  // (unit of x) standard error; NaN if the record is too short for one
  double phase_error = 0;      // (rad) the same; large compared with 1: the phase is unknown
  double noise_density =
      0;  // (unit of x)^2/Hz, one-sided, near the line: amplitude_error^2 T for many periods
};

struct LockInResult {
  std::array<Line, 3> lines;  // of f, 2 f, 3 f; the first `harmonics` are filled
  std::size_t harmonics = 0;
  std::size_t samples = 0;
  double mean = 0;          // (unit of x) of the fitted drift over `duration`
  double residual_rms = 0;  // (unit of x) of x minus the fit, known to 1e-7 of the rms of x - x(t0)
};

class LockIn {
 public:
  // Doubles that a lock-in keeps, for any length of the record: 24 to 1133.
  static std::size_t state_size(const LockInOptions& options);

  // Goes on with what `state` holds; all zeros: no sample yet. The memory is the caller's and is the whole state. Throws
  // Error for options out of range or another size.
  LockIn(const LockInOptions& options, std::span<double> state);

  // Adds a sample, at any time (s); value below 1e150 in size.
  void add(double time, double value);

  std::size_t samples() const;  // so far

  // Throws Error if there are too few samples or if their times do not determine the terms.
  LockInResult result() const;

 private:
  LockInOptions options_;
  std::span<double> state_;
  std::size_t model_ = 0, columns_ = 0;
};

// What is done against drift before or in the fit.
enum class Detrending {
  polynomial,     // as described above
  period_average  // the mean over one period is subtracted first (period_average.hpp), then as above
};

// The same for arrays of one length; `duration` is that of the record if it is 0. Times increase. Throws Error.
LockInResult lock_in(std::span<const double> times, std::span<const double> values, LockInOptions options,
                     Detrending detrending = Detrending::polynomial);

}  // namespace scree::signals
