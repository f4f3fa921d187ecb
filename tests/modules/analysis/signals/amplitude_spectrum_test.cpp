#include "signals.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/signals/amplitude_spectrum.hpp>

using namespace scree::signals;
using scree::test::equal_times;
using scree::test::sine;

namespace {

struct SampledSignal {
  std::vector<double> times, values;
  AmplitudeSpectrum spectrum() const { return amplitude_spectrum(times[1] - times[0], values); }
};

SampledSignal record(double step, std::size_t count, const std::function<double(double)>& x) {
  SampledSignal made{equal_times(count, step), {}};
  for (const double t : made.times) made.values.push_back(x(t));
  return made;
}

}  // namespace

TEST_CASE("a sine at a multiple of the resolution has its amplitude there, on a drift",
          "[amplitude_spectrum]") {
  // 1000 periods of 4 samples less one: a straight line fits at most 6/1000 of the sine.
  const auto even = record(0.01, 4000, [](double t) { return sine(0.3, 25, 1, t) + 7 + 0.1 * t; });
  const AmplitudeSpectrum spectrum = even.spectrum();
  CHECK(spectrum.resolution == Approx(1 / 40.0));
  REQUIRE(spectrum.amplitude.size() == 2001);
  CHECK(spectrum.amplitude[1000] == Approx(0.3).epsilon(1e-4));
  CHECK(spectrum.amplitude[0] < 1e-3);
  CHECK(spectrum.amplitude[400] < 1e-7);
}

TEST_CASE("between multiples of the resolution a sine keeps 0.85 of its amplitude", "[amplitude_spectrum]") {
  const auto made = record(0.01, 4001, [](double t) { return sine(1, 20.5 / 40.01 * 20, 1, t); });
  const auto& amplitude = made.spectrum().amplitude;
  const double highest = *std::max_element(amplitude.begin(), amplitude.end());
  CHECK(highest > 2 / std::numbers::pi / 0.75 - 0.01);
  CHECK(highest < 1.001);
}

TEST_CASE("a sine at half the sampling rate is counted once", "[amplitude_spectrum]") {
  const auto made = record(0.5, 1000, [](double t) { return std::cos(2 * std::numbers::pi * t); });
  CHECK(made.spectrum().amplitude.back() == Approx(1).epsilon(1e-5));
}

TEST_CASE("the same values give the same bits", "[amplitude_spectrum]") {
  const auto made = record(0.01, 3001, [](double t) { return std::exp(-t) + sine(1, 3, 0, t); });
  CHECK(made.spectrum().amplitude == made.spectrum().amplitude);
  CHECK_THROWS_AS(amplitude_spectrum(1, std::vector<double>(3)), scree::Error);
}

TEST_CASE("lines are found to a small part of the resolution, the strongest first", "[strongest_lines]") {
  const auto made = record(0.01, 10000, [](double t) {
    return sine(0.2, 3.14159, 1, t) + sine(1, 7.77777, -2, t) + 0.01 * t * t;
  });
  const auto lines = strongest_lines(made.times, made.values, made.spectrum(), 2);
  REQUIRE(lines.size() == 2);
  // The parabola is fitted; lines at 464 resolutions have 1 / (464 pi) of each other before the first of six
  // rounds.
  CHECK(std::abs(lines[0].frequency - 7.77777) < 1e-9);
  CHECK(std::abs(lines[1].frequency - 3.14159) < 1e-9);
  CHECK(lines[0].amplitude == Approx(1).epsilon(1e-9));
  CHECK(lines[1].amplitude == Approx(0.2).epsilon(1e-9));
}

TEST_CASE("lines of equal strength that are three resolutions apart are told apart", "[strongest_lines]") {
  for (const double apart : {3.2, 4.0, 5.0, 6.0}) {
    CAPTURE(apart);
    const double first = 60.3, second = first + apart / 10;  // of a record of 10 s
    const auto made =
        record(0.0025, 4001, [&](double t) { return sine(1, first, 0.4, t) + sine(1, second, -1, t); });
    auto lines = strongest_lines(made.times, made.values, made.spectrum(), 5);
    REQUIRE(lines.size() == 2);
    if (lines[0].frequency > lines[1].frequency) std::swap(lines[0], lines[1]);
    // Each of seven fits leaves less than 0.1 of a line, and of a resolution of 0.1 Hz, in the other.
    CHECK(std::abs(lines[0].frequency - first) < 1e-8);
    CHECK(std::abs(lines[1].frequency - second) < 1e-8);
    for (const FoundLine& line : lines) CHECK(std::abs(line.amplitude - 1) < 1e-7);
  }
}

TEST_CASE("weak lines beside strong ones are found, also at steps that differ", "[strongest_lines]") {
  const auto values = [](double t) {
    return sine(1, 37.3, 0.4, t) + sine(0.003, 91.7, -1, t) + sine(0.001, 400, 2, t);
  };
  const auto made = record(0.001, 2000, values);
  std::vector<double> times = made.times;
  std::mt19937_64 random(7);
  for (double& t : times) t += 1e-4 * (2 * double(random() >> 11) * 0x1p-53 - 1);
  const bool equal = GENERATE(true, false);
  CAPTURE(equal);
  std::vector<double> x;
  for (const double t : equal ? made.times : times) x.push_back(values(t));
  const auto lines = strongest_lines(equal ? made.times : times, x, made.spectrum(), 3);
  REQUIRE(lines.size() == 3);
  // The fits leave 1 / (pi 108 resolutions) of each other in the first of seven, and round-off.
  CHECK(std::abs(lines[1].frequency - 91.7) < 1e-9);
  CHECK(std::abs(lines[1].amplitude - 0.003) < 1e-12);
  CHECK(std::abs(lines[2].amplitude - 0.001) < 1e-12);
}

TEST_CASE("white noise has no lines, and frequencies of lines in it scatter as their error says",
          "[strongest_lines]") {
  std::mt19937_64 random(4);
  std::normal_distribution<double> noise(0, 0.5);
  int covered = 0;
  constexpr int cases = 300;  // the share of 300 cases is known to 2.7 %
  for (int k = 0; k < cases; ++k) {
    const auto quiet = record(0.01, 1000, [&](double) { return noise(random); });
    CHECK(strongest_lines(quiet.times, quiet.values, quiet.spectrum(), 5).empty());
    const auto made = record(0.01, 1000, [&](double t) { return sine(1, 12.345, 1, t) + noise(random); });
    const auto lines = strongest_lines(made.times, made.values, made.spectrum(), 5);
    REQUIRE(lines.size() == 1);
    covered += std::abs(lines[0].frequency - 12.345) < lines[0].frequency_error;
  }
  CHECK(double(covered) / cases == Approx(0.68).margin(0.08));
}

TEST_CASE("hardly a random walk has a line", "[strongest_lines]") {
  std::mt19937_64 random(12);
  std::normal_distribution<double> noise(0, 1);
  int lines = 0;
  for (int k = 0; k < 100; ++k) {
    double at = 0;
    const auto walk = record(0.01, 1000, [&](double) { return at += noise(random); });
    lines += int(strongest_lines(walk.times, walk.values, walk.spectrum(), 5).size());
  }
  CHECK(lines <= 5);  // 1 expected; more than 5 once in 1600 times
}

TEST_CASE("a line beside an offset whose round-off takes all the rest is found", "[strongest_lines]") {
  // At 1e15 numbers are 1/8 apart, so that candidates of the round-off alone may leave nothing to be fitted.
  const auto made = record(0.001, 400, [](double t) { return 1e15 + sine(2, 50, 0.3, t); });
  const auto lines = strongest_lines(made.times, made.values, made.spectrum(), 5);
  REQUIRE(!lines.empty());
  CHECK(lines[0].frequency == Approx(50).epsilon(1e-3));
  CHECK(lines[0].amplitude == Approx(2).margin(0.125));
  for (const FoundLine& line : lines) CHECK(line.amplitude > 0);
}

TEST_CASE("values at unequal times are put on equal steps within the stated bound", "[amplitude_spectrum]") {
  const auto times = scree::test::random_times(1000, 0.01, 5);
  std::vector<double> x;
  for (const double t : times) x.push_back(sine(1, 2, 0, t));
  CHECK(unevenness(times) > 1e-3);
  CHECK(unevenness(equal_times(1000, 0.1, 3)) < 1e-9);
  const auto even = at_equal_steps(times, x);
  REQUIRE(even.size() == x.size());
  const double step = (times.back() - times.front()) / 999;
  for (std::size_t k = 0; k < even.size(); ++k)
    CHECK(std::abs(even[k] - sine(1, 2, 0, step * double(k))) <
          std::pow(2 * std::numbers::pi * 2 * 0.018, 2) / 8);
}
