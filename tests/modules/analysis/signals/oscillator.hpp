#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <vector>

namespace scree::test {

// y'' + 2 g y' + w^2 y = x, with x constant in each step: integrated exactly, and its exact transfer function
// from the values of x to those of y at the beginnings of the steps.
class Oscillator {
 public:
  // frequency: without damping (Hz); step: (s).
  Oscillator(double frequency, double quality, double step) : step_(step) {
    const double w = 2 * std::numbers::pi * frequency, g = w / (2 * quality),
                 damped = std::sqrt(w * w - g * g);
    const double decay = std::exp(-g * step), c = decay * std::cos(damped * step);
    const double s = decay * std::sin(damped * step) / damped;
    a_ = c + g * s, b_ = s, c_ = -w * w * s, d_ = c - g * s;
    p_ = (1 - a_) / (w * w), q_ = s;
  }

  std::vector<double> response(std::span<const double> x) const {
    std::vector<double> y;
    double position = 0, velocity = 0;
    for (const double drive : x) {
      y.push_back(position);
      const double next = a_ * position + b_ * velocity + p_ * drive;
      velocity = c_ * position + d_ * velocity + q_ * drive;
      position = next;
    }
    return y;
  }

  // Of (z - [a b; c d]) [y v] = [p q] x at z = exp(2 pi i f step).
  std::complex<double> transfer(double frequency) const {
    const auto z = std::polar(1.0, 2 * std::numbers::pi * frequency * step_);
    return (p_ * (z - d_) + b_ * q_) / ((z - a_) * (z - d_) - b_ * c_);
  }

 private:
  double step_, a_, b_, c_, d_, p_, q_;
};

}  // namespace scree::test
