#include "fourier.hpp"

#include <cmath>
#include <limits>
#include <new>
#include <numbers>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::signals {

namespace {

int checked(std::size_t count) {
  if (count == 0 || count > std::size_t(std::numeric_limits<int>::max()))
    throw Error(fmt::format("spectrum: {} values; give 1 to {}", count, std::numeric_limits<int>::max()));
  return int(count);
}

}  // namespace

Fourier::Fourier(std::size_t count) : count_(count) {
  const int number = checked(count);
  values_ = fftw_alloc_real(2 * (count / 2 + 1));
  if (!values_) throw std::bad_alloc();
  plan_ = fftw_plan_dft_r2c_1d(number, values_, reinterpret_cast<fftw_complex*>(values_), FFTW_ESTIMATE);
}

Fourier::~Fourier() {
  fftw_destroy_plan(plan_);
  fftw_free(values_);
}

std::span<const std::complex<double>> Fourier::transform() {
  fftw_execute(plan_);
  return {reinterpret_cast<const std::complex<double>*>(values_), count_ / 2 + 1};
}

std::vector<double> hann(std::size_t count) {
  std::vector<double> window(count);
  for (std::size_t j = 0; j < count; ++j)
    window[j] = std::pow(std::sin(std::numbers::pi * double(j) / double(count)), 2);
  return window;
}

}  // namespace scree::signals
