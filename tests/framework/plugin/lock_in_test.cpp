#include "signals.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <catch2/catch.hpp>

#include <scree/plugin/lock_in.hpp>

using namespace scree;
using scree::test::equal_times;
using scree::test::PinkNoise;
using scree::test::sine;
using scree::test::turned_by;

namespace {

LockInResult lock_in(const std::vector<double>& times, const std::vector<double>& values,
                     LockInOptions options) {
  if (options.duration == 0) options.duration = times.back() - times.front();
  std::vector<double> state(LockIn::state_size(options));
  LockIn fit(options, state);
  for (std::size_t k = 0; k < times.size(); ++k) fit.add(times[k], values[k]);
  return fit.result();
}

// Mean of the squares of (estimate - truth), and share of |estimate - truth| below its standard error.
struct Scatter {
  double square = 0, covered = 0;
  int cases = 0;
  void add(double deviation, double error) {
    square += deviation * deviation, covered += std::abs(deviation) <= error, ++cases;
  }
  double variance() const { return square / cases; }
  double share() const { return covered / cases; }
};

}  // namespace

TEST_CASE("in white noise, amplitude and phase scatter as the Cramer-Rao bound says", "[lock_in]") {
  constexpr int cases = 4000, samples = 200;  // the variance of 4000 cases is known to 2.2 %
  constexpr double amplitude = 1, phase = 0.7, sigma = 0.1;
  std::mt19937_64 random(11);
  std::normal_distribution<double> noise(0, sigma);
  const auto times = equal_times(samples, 0.01);
  LockInOptions options;
  options.frequency = 10, options.drift_degree = 0;
  Scatter amplitude_scatter, phase_scatter;
  for (int k = 0; k < cases; ++k) {
    std::vector<double> x;
    for (const double t : times) x.push_back(sine(amplitude, 10, phase, t) + noise(random));
    const SpectralLine line = lock_in(times, x, options).lines[0];
    amplitude_scatter.add(line.amplitude - amplitude, line.amplitude_error);
    phase_scatter.add(line.phase - phase, line.phase_error);
  }
  const double bound = 2 * sigma * sigma / samples;
  CHECK(amplitude_scatter.variance() == Approx(bound).epsilon(0.1));
  CHECK(phase_scatter.variance() == Approx(bound / (amplitude * amplitude)).epsilon(0.1));
  CHECK(amplitude_scatter.share() == Approx(0.68).margin(0.05));
  CHECK(phase_scatter.share() == Approx(0.68).margin(0.05));
}

TEST_CASE("in 1/f noise the standard errors cover the true errors", "[lock_in]") {
  constexpr int cases = 1000, samples = 1000;  // the share of 1000 cases is known to 1.5 %
  constexpr std::array truth = {1.0, 0.5, 0.25};
  std::mt19937_64 random(5);
  const auto times = equal_times(samples, 0.01);
  LockInOptions options;
  options.frequency = 2.1;
  std::array<Scatter, 3> amplitude_scatter, phase_scatter;
  for (int k = 0; k < cases; ++k) {
    scree::test::PinkNoise noise(samples, random);
    std::vector<double> x;
    for (const double t : times) {
      double value = 0.1 * noise.next();
      for (int h = 1; h <= 3; ++h) value += sine(truth[h - 1], h * 2.1, 1, t);
      x.push_back(value);
    }
    const LockInResult result = lock_in(times, x, options);
    for (int h = 0; h < 3; ++h) {
      amplitude_scatter[h].add(result.lines[h].amplitude - truth[h], result.lines[h].amplitude_error);
      phase_scatter[h].add(result.lines[h].phase - 1, result.lines[h].phase_error);
    }
  }
  for (int h = 0; h < 3; ++h) {
    CHECK(amplitude_scatter[h].share() == Approx(0.68).margin(0.05));
    CHECK(phase_scatter[h].share() == Approx(0.68).margin(0.05));
  }
  // White noise of the same power would have been twice as strong at 3 f as at f, in amplitude by sqrt(3).
  CHECK(amplitude_scatter[0].variance() > 2 * amplitude_scatter[2].variance());
}

TEST_CASE("of a part of a period, amplitude and phase have errors of their own", "[lock_in]") {
  std::mt19937_64 random(6);
  std::normal_distribution<double> noise(0, 0.01);
  LockInOptions options;
  options.frequency = 1, options.drift_degree = 0, options.harmonics = 1;
  Scatter amplitude_scatter, phase_scatter;
  double ratio = 0;
  for (int k = 0; k < 1000; ++k) {
    const auto times = equal_times(60, 0.01);
    std::vector<double> x;
    for (const double t : times) x.push_back(sine(1, 1, 0, t) + noise(random));
    const SpectralLine line = lock_in(times, x, options).lines[0];
    amplitude_scatter.add(line.amplitude - 1, line.amplitude_error);
    phase_scatter.add(line.phase, line.phase_error);
    ratio = line.amplitude_error / line.phase_error;
  }
  CHECK(amplitude_scatter.share() == Approx(0.68).margin(0.05));
  CHECK(phase_scatter.share() == Approx(0.68).margin(0.05));
  CHECK(std::abs(std::log(ratio)) > 0.3);
}

TEST_CASE("in a short record a harmonic that is not fitted is not taken for noise", "[lock_in]") {
  LockInOptions options;
  options.frequency = 1, options.duration = 6, options.harmonics = 1, options.drift_degree = 0;
  const auto times = equal_times(600, 0.01);
  std::vector<double> x;
  for (const double t : times) x.push_back(sine(1, 1, 0, t) + sine(0.5, 2, 0, t));
  const SpectralLine line = lock_in(times, x, options).lines[0];
  CHECK(line.amplitude == Approx(1).epsilon(1e-12));
  CHECK(line.amplitude_error < 1e-12);
}

TEST_CASE("a frequency that is off by a tenth of 1/T shows in the error", "[lock_in]") {
  const auto times = equal_times(2000, 1e-3);
  std::vector<double> x;
  for (const double t : times) x.push_back(sine(1, 50.05, 0, t));
  LockInOptions options;
  options.frequency = 50;
  const SpectralLine line = lock_in(times, x, options).lines[0];
  CHECK(std::abs(line.amplitude - 1) > 0.01);  // 1 - sinc(0.1)
  CHECK(std::abs(line.amplitude - 1) < 2 * line.amplitude_error);
}

TEST_CASE("a record of few periods has errors too, and one without spare samples none", "[lock_in]") {
  std::mt19937_64 random(2);
  std::normal_distribution<double> noise(0, 0.1);
  LockInOptions options;
  options.frequency = 1, options.drift_degree = 0, options.harmonics = 1;
  Scatter scatter;
  for (int k = 0; k < 1000; ++k) {
    const auto times = equal_times(60, 0.05);  // 3 periods
    std::vector<double> x;
    for (const double t : times) x.push_back(sine(1, 1, 0, t) + noise(random));
    const SpectralLine line = lock_in(times, x, options).lines[0];
    scatter.add(line.amplitude - 1, line.amplitude_error);
  }
  CHECK(scatter.share() == Approx(0.68).margin(0.05));
  const SpectralLine line = lock_in(equal_times(3, 0.3), equal_times(3, 1), options).lines[0];
  CHECK(std::isnan(line.amplitude_error));
  const SpectralLine none = lock_in(equal_times(60, 0.05), std::vector<double>(60, 3.0), options).lines[0];
  CHECK(none.amplitude == 0);
  CHECK(none.amplitude_error == 0);
  CHECK(none.phase_error == std::numeric_limits<double>::infinity());
}
