#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

namespace scree::test {

using Complex = std::complex<double>;

inline constexpr Complex i(0, 1);

inline std::vector<double> band(double low, double high, std::size_t count) {
  std::vector<double> f(count);
  for (std::size_t k = 0; k < count; ++k) f[k] = low + (high - low) * double(k) / double(count - 1);
  return f;
}

// Around the mode 3λ/4 of a packing, at about 21 kHz.
struct FrequencyGrid {
  double low, high;
  std::size_t count;
};
inline constexpr std::array grids_of_packing = {FrequencyGrid{12e3, 30e3, 61}, FrequencyGrid{10e3, 34e3, 97},
                                                FrequencyGrid{15e3, 27e3, 61}};

// A mode: frequency and width (Hz), height and phase of its strength.
struct Truth {
  double frequency, width, amplitude, phase;
};

inline Complex value(const Truth& mode, double f) {
  const Complex strength = std::polar(mode.amplitude * mode.frequency * mode.width, mode.phase);
  return strength / (mode.frequency * mode.frequency - f * f + i * f * mode.width);
}

inline std::vector<Complex> response(const std::vector<double>& f, const std::vector<Truth>& modes,
                                     Complex c0 = {}, Complex c1 = {}) {
  std::vector<Complex> h;
  for (const double at : f) {
    h.push_back(c0 + c1 * (at - 100));
    for (const Truth& mode : modes) h.back() += value(mode, at);
  }
  return h;
}

inline std::vector<double> sizes(const std::vector<Complex>& h) {
  std::vector<double> a;
  for (const Complex& one : h) a.push_back(std::abs(one));
  return a;
}

// Of both parts together.
class Noise {
 public:
  Noise(double rms, unsigned seed) : random_(seed), gauss_(0, rms / std::sqrt(2.0)) {}
  std::vector<Complex> added(std::vector<Complex> h) {
    for (Complex& one : h) one += Complex(gauss_(random_), gauss_(random_));
    return h;
  }
  std::vector<double> added(std::vector<double> a) {
    for (double& one : a) one += std::sqrt(2.0) * gauss_(random_);
    return a;
  }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> gauss_;
};

// Share of estimates within their errors.
struct Coverage {
  int covered = 0, cases = 0;
  void add(double estimate, double truth, double error) {
    covered += std::abs(estimate - truth) < error, ++cases;
  }
  double share() const { return double(covered) / cases; }
};

}  // namespace scree::test
