#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace scree::test {

inline double sine(double amplitude, double frequency, double phase, double time) {
  return amplitude * std::sin(2 * std::numbers::pi * frequency * time + phase);
}

inline std::vector<double> equal_times(std::size_t count, double step, double start = 0) {
  std::vector<double> times(count);
  for (std::size_t k = 0; k < count; ++k) times[k] = start + step * double(k);
  return times;
}

// Steps from 0.2 to 1.8 of the mean.
inline std::vector<double> random_times(std::size_t count, double mean_step, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> factor(0.2, 1.8);
  std::vector<double> times(count);
  for (std::size_t k = 1; k < count; ++k) times[k] = times[k - 1] + mean_step * factor(random);
  return times;
}

// Noise of density 1/f from 1/(4 count) to 1/8 per sample: relaxations of equal variance, two per octave.
class PinkNoise {
 public:
  PinkNoise(std::size_t count, std::mt19937_64& random) : random_(random) {
    for (double time = 1; time < double(4 * count); time *= std::numbers::sqrt2)
      parts_.push_back({std::exp(-1 / time), gauss_(random)});
  }
  double next() {
    double sum = 0;
    for (Part& part : parts_) {
      part.value = part.decay * part.value + std::sqrt(1 - part.decay * part.decay) * gauss_(random_);
      sum += part.value;
    }
    return sum;
  }

 private:
  struct Part {
    double decay, value;
  };
  std::mt19937_64& random_;
  std::normal_distribution<double> gauss_;
  std::vector<Part> parts_;
};

// Difference of two phases in [-pi, pi].
inline double turned_by(double a, double b) { return std::remainder(a - b, 2 * std::numbers::pi); }

}  // namespace scree::test
