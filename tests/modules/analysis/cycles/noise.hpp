#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

// Series of noise, and how often a test with a stated significance may call them something.

namespace scree::test {

constexpr int samples = 500;
constexpr double significance = 0.005;  // of the two tests, the default

// The number of samples for a share, plus three standard deviations.
inline int at_most(double share) { return int(share * samples + 3 * std::sqrt(share * samples)); }

// Makes so many values with a generator of random numbers.
using Series = std::function<std::vector<double>(std::mt19937_64&, std::size_t)>;

// Independent values from a distribution.
template <class Distribution>
Series independent(Distribution distribution) {
  return [distribution](std::mt19937_64& random, std::size_t count) {
    Distribution fresh = distribution;
    std::vector<double> values(count);
    for (double& value : values) value = fresh(random);
    return values;
  };
}

// Normal values plus a share of the value before; 1 is a random walk.
inline Series remembering(double part) {
  return [part](std::mt19937_64& random, std::size_t count) {
    std::normal_distribution<double> normal;
    std::vector<double> values(count);
    double value = part < 1 ? normal(random) / std::sqrt(1 - part * part) : 0;
    for (double& x : values) {
      x = value;
      value = part * value + normal(random);
    }
    return values;
  };
}

inline std::vector<Series> kinds_of_noise() {
  return {independent(std::normal_distribution<double>()),
          independent(std::uniform_real_distribution<double>()),
          independent(std::exponential_distribution<double>()),
          remembering(0.5),
          remembering(0.9),
          remembering(1.0)};
}

// In how many samples a test calls a series something.
template <class Test>
int called(std::size_t count, const Series& series, const Test& test) {
  int sum = 0;
  for (unsigned seed = 1; seed <= samples; ++seed) {
    std::mt19937_64 random(seed);
    sum += test(series(random, count));
  }
  return sum;
}

}  // namespace scree::test
