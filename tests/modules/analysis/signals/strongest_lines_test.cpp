#include "signals.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <random>

#include <catch2/catch.hpp>

#include <scree/signals/amplitude_spectrum.hpp>

using namespace scree::signals;
using scree::test::equal_times;
using scree::test::sine;
using scree::test::turned_by;

namespace {

constexpr int noise_cases = 1000;  // a share of 0.68 of so many is known to 1.5 %
constexpr std::size_t record_samples = 250;
constexpr double record_step = 0.04, base_frequency = 2.1;
constexpr std::array line_amplitudes = {1.0, 0.5};  // of f and 2 f, which leak into each other

// Shares of estimates within their errors.
struct LineCoverage {
  std::array<double, 2> frequency = {}, phase = {}, amplitude = {};

  void add(const FoundLine& line, std::size_t h) {
    const double hz = base_frequency * double(h + 1);
    frequency[h] += (std::abs(line.frequency - hz) < line.frequency_error) / double(noise_cases);
    phase[h] += (std::abs(turned_by(line.phase, 1)) < line.phase_error) / double(noise_cases);
    amplitude[h] +=
        (std::abs(line.amplitude - line_amplitudes[h]) < line.amplitude_error) / double(noise_cases);
  }
};

using NoiseSource = std::function<double()>;  // the next value of the noise

LineCoverage coverage(double start, const std::function<NoiseSource(std::mt19937_64&)>& noise_of) {
  const auto times = equal_times(record_samples, record_step, start);
  std::mt19937_64 random(5);
  LineCoverage found;
  for (int k = 0; k < noise_cases; ++k) {
    const NoiseSource noise = noise_of(random);
    std::vector<double> x;
    for (const double t : times)
      x.push_back(noise() + sine(line_amplitudes[0], base_frequency, 1, t) +
                  sine(line_amplitudes[1], 2 * base_frequency, 1, t));
    const auto lines = strongest_lines(times, x, amplitude_spectrum(record_step, x), 2);
    REQUIRE(lines.size() == 2);
    for (std::size_t h = 0; h < 2; ++h) found.add(lines[h], h);
  }
  return found;
}

void check(const LineCoverage& found) {
  for (std::size_t h = 0; h < 2; ++h) {
    CHECK(found.frequency[h] == Approx(0.68).margin(0.05));
    CHECK(found.phase[h] == Approx(0.68).margin(0.05));
    CHECK(found.amplitude[h] == Approx(0.68).margin(0.05));
  }
}

NoiseSource white_noise(std::mt19937_64& random) {
  return [&random] { return std::normal_distribution<double>(0, 0.1)(random); };
}

NoiseSource pink_noise(std::mt19937_64& random) {
  return [noise = scree::test::PinkNoise(record_samples, random)]() mutable { return 0.1 * noise.next(); };
}

}  // namespace

TEST_CASE("errors of frequency, phase at 0 and amplitude of found lines cover the true ones in white noise",
          "[strongest_lines]") {
  check(coverage(0, white_noise));
  check(coverage(5, white_noise));  // the phase at 0 lies before the record
}

TEST_CASE("errors of frequency, phase at 0 and amplitude of found lines cover the true ones in 1/f noise",
          "[strongest_lines]") {
  check(coverage(0, pink_noise));
}

TEST_CASE("lines of harmonics without noise do not lean on each other", "[strongest_lines]") {
  const auto times = equal_times(record_samples, record_step);
  std::vector<double> x;
  for (const double t : times) x.push_back(sine(1, 2.13, 1, t) + sine(0.1, 4.26, -1, t));
  const auto lines = strongest_lines(times, x, amplitude_spectrum(record_step, x), 2);
  REQUIRE(lines.size() == 2);
  // Each has 0.05 of the other at 21 resolutions, squared with each of six rounds: 1e-8.
  CHECK(std::abs(lines[0].frequency - 2.13) < 1e-7);
  CHECK(std::abs(lines[1].frequency - 4.26) < 1e-7);
  CHECK(std::abs(lines[1].amplitude - 0.1) < 1e-7);
  CHECK(std::abs(turned_by(lines[1].phase, -1)) < 1e-6);
}
