#include "error_shares.hpp"
#include "signals.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/signals/amplitude_spectrum.hpp>

using namespace scree::signals;
using scree::test::equal_times;
using scree::test::ErrorShares;

namespace {

double ring_down(double frequency, double quality, double phase, double since) {
  return scree::test::sine(std::exp(-std::numbers::pi * frequency * since / quality), frequency, phase,
                           since);
}

}  // namespace

// Line and drift are fitted in turn, six times; each round lowers the error that the drift leaves in a line.
TEST_CASE("a decay has its frequency, Q and amplitude at the beginning", "[strongest_lines]") {
  for (const double quality : {20.0, 50.0, 400.0}) {
    const double small = quality < 50 ? 1e-4 : 1e-7;
    const double start = 2, frequency = 83.21, phase = 0.7;
    const auto times = equal_times(2000, 0.0005, start);
    std::vector<double> x;
    for (const double t : times) x.push_back(3 - t + 0.2 * ring_down(frequency, quality, phase, t - start));
    const auto lines = strongest_lines(times, x, amplitude_spectrum(0.0005, x), 3);
    CAPTURE(quality);
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].frequency == Approx(frequency).epsilon(small / quality));
    CHECK(lines[0].quality == Approx(quality).epsilon(small));
    CHECK(lines[0].amplitude == Approx(0.2).epsilon(small));
    const double at_zero = phase - 2 * std::numbers::pi * frequency * start;
    CHECK(std::abs(scree::test::turned_by(lines[0].phase, at_zero)) < 10 * small);
  }
}

// Shares of 100 cases have standard deviations of 0.047 and 0.022; the margins are four of them.
TEST_CASE("errors of a decay cover the true ones in white noise", "[strongest_lines]") {
  constexpr int cases = 100;
  std::mt19937_64 random(3);
  std::normal_distribution<double> gauss(0, 0.1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto times = equal_times(1500, 1.0 / 1500);
  ErrorShares of_frequency, of_quality, of_amplitude, of_phase;
  for (int k = 0; k < cases; ++k) {
    const double frequency = 60 + 60 * uniform(random), phase = 3 * uniform(random);
    std::vector<double> x;
    for (const double t : times) x.push_back(gauss(random) + ring_down(frequency, 50, phase, t));
    const auto lines = strongest_lines(times, x, amplitude_spectrum(1.0 / 1500, x), 3);
    REQUIRE(lines.size() == 1);
    const FoundLine& line = lines[0];
    of_frequency.add(line.frequency - frequency, line.frequency_error);
    of_quality.add(line.quality - 50, line.quality_error);
    of_amplitude.add(line.amplitude - 1, line.amplitude_error);
    of_phase.add(scree::test::turned_by(line.phase, phase), line.phase_error);
  }
  for (const ErrorShares& shares : {of_frequency, of_quality, of_amplitude, of_phase}) {
    CHECK(shares.one / double(cases) == Approx(0.68).margin(0.19));
    CHECK(shares.two / double(cases) > 0.95 - 0.09);
  }
}

TEST_CASE("steady lines do not decay, and a decay beside one is told from it", "[strongest_lines]") {
  std::mt19937_64 random(8);
  std::normal_distribution<double> gauss(0, 0.1);
  const auto times = equal_times(2000, 0.0005);
  for (int k = 0; k < 20; ++k) {
    std::vector<double> x;
    for (const double t : times)
      x.push_back(gauss(random) + scree::test::sine(0.5, 40.3, 1, t) + ring_down(90.7, 60, 0.5, t));
    const auto lines = strongest_lines(times, x, amplitude_spectrum(0.0005, x), 3);
    REQUIRE(lines.size() == 2);
    CHECK(lines[0].quality == Approx(60).margin(5 * lines[0].quality_error));
    CHECK(lines[1].quality == 0);
    CHECK(lines[1].frequency == Approx(40.3).margin(5 * lines[1].frequency_error));
  }
}
