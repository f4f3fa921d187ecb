#include "signals.hpp"

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/signals/amplitude_spectrum.hpp>

using namespace scree::signals;
using scree::test::equal_times;

namespace {

// How often the errors cover the frequency of a line of amplitude 1 in noise of 0.1, in records of 1 s.
struct DriftCover {
  static constexpr int cases = 40;
  static constexpr std::size_t samples = 1000;
  int found = 0, one = 0, two = 0;

  explicit DriftCover(const std::function<double(double)>& drift, double noise = 0.1) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> gauss(0, noise);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto times = equal_times(samples, 1.0 / samples);
    for (int k = 0; k < cases; ++k) {
      const double frequency = 20 + 20 * uniform(random), phase = 6 * uniform(random);
      std::vector<double> x;
      for (const double t : times)
        x.push_back(drift(t) + gauss(random) + scree::test::sine(1, frequency, phase, t));
      const auto lines = strongest_lines(times, x, amplitude_spectrum(1.0 / samples, x), 3);
      if (lines.empty() || lines[0].quality > 0) continue;
      const double off = std::abs(lines[0].frequency - frequency) / lines[0].frequency_error;
      ++found, one += off < 1, two += off < 2;
    }
  }
};

}  // namespace

// Shares of 40 cases have standard deviations of 0.074 and 0.034; the margins are 4 and 3.5 of them.
TEST_CASE("errors of a line hold beside relaxations ten times as large", "[strongest_lines]") {
  const std::vector<std::function<double(double)>> drifts = {
      [](double t) { return 10 * std::exp(-4 * t); }, [](double t) { return 10 * std::log(1 + 50 * t); },
      [](double t) { return 10 * std::sqrt(t); }};
  for (std::size_t d = 0; d < drifts.size(); ++d) {
    const DriftCover cover(drifts[d]);
    CAPTURE(d, cover.found, cover.one, cover.two);
    CHECK(cover.found == DriftCover::cases);
    CHECK(cover.one / double(DriftCover::cases) == Approx(0.68).margin(0.30));
    CHECK(cover.two / double(DriftCover::cases) > 0.95 - 0.12);
  }
}

TEST_CASE("a line beside an exponential is found to a small part of the resolution", "[strongest_lines]") {
  const auto times = equal_times(4000, 0.01);
  std::vector<double> x;
  for (const double t : times) x.push_back(10 * std::exp(-t / 10) + scree::test::sine(1, 2.13, 1, t));
  const auto lines = strongest_lines(times, x, amplitude_spectrum(0.01, x), 1);
  REQUIRE(lines.size() == 1);
  // Means of two samples stand for the relaxation, which is curved over them by (0.02 s / 10 s)^2 / 24 of 10.
  CHECK(lines[0].frequency == Approx(2.13).margin(2e-6));
  CHECK(lines[0].amplitude == Approx(1).margin(2e-6));
}
