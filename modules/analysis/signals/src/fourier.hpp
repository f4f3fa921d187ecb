#pragma once

#include <complex>
#include <cstddef>
#include <fftw3.h>
#include <span>
#include <vector>

namespace scree::signals {

// Discrete Fourier transform of real values, X_k = sum of x_j exp(-2 pi i j k / n), in place. Planned without
// measuring, so that the same values give the same bits. FFTW's planner serves one thread at a time.
class Fourier {
 public:
  explicit Fourier(std::size_t count);
  ~Fourier();
  Fourier(const Fourier&) = delete;
  Fourier& operator=(const Fourier&) = delete;

  // The input, which each transform overwrites.
  std::span<double> values() { return {values_, count_}; }
  // count / 2 + 1 numbers, valid until values() is set again.
  std::span<const std::complex<double>> transform();

 private:
  std::size_t count_;
  double* values_;
  fftw_plan plan_;
};

// Hann window of a period of `count` samples: sin^2(pi j / count).
std::vector<double> hann(std::size_t count);

}  // namespace scree::signals
