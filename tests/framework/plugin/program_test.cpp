#include "numbers.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/plugin/program.hpp>

using scree::Program;
using scree::test::epsilon;
using std::numbers::pi;

namespace {

// Opaque to the compiler, which would otherwise see the length of the data and warn about the kinds that do
// not hold.
Program program(const std::vector<double>& data) {
  const double* const volatile first = data.data();
  return Program({first, data.size()});
}

// Central difference. Its error is step²/6 times the third derivative, plus 2 roundings of the value over 2
// steps.
void check_rate(const Program& p, double time, double third_derivative, double size) {
  const double step = 1e-5;
  const double slope = (p(time + step) - p(time - step)) / (2 * step);
  const double allowed = step * step / 6 * third_derivative + 8 * epsilon * size / step;
  INFO("t = " << time);
  CHECK(std::abs(p.rate(time) - slope) <= allowed);
}

}  // namespace

TEST_CASE("a program that is not given reports it") {
  CHECK_FALSE(Program().given());
  const std::vector<double> data = {0, 3.5};
  CHECK(program(data).given());
}

TEST_CASE("a constant has its value and zero derivative at any time") {
  const std::vector<double> data = {0, 3.5};
  for (const double t : {-1.0, 0.0, 1e9}) {
    CHECK(program(data)(t) == 3.5);
    CHECK(program(data).rate(t) == 0);
  }
}

TEST_CASE("a sine is mean + amplitude sin(2 pi f t + phase)") {
  const double mean = 2, amplitude = 0.5, frequency = 3, phase = 0.7;
  const std::vector<double> data = {1, mean, amplitude, frequency, phase};
  const Program p = program(data);
  // Quarter periods counted from phase zero: mean, crest, mean, trough. The argument has 3 roundings of its
  // size.
  const double start = -phase / (2 * pi * frequency);
  const double expected[] = {mean, mean + amplitude, mean, mean - amplitude};
  for (int k = 0; k < 8; ++k) {
    const double t = start + 0.25 * k / frequency;
    CHECK(std::abs(p(t) - expected[k % 4]) <= 4 * epsilon * (mean + amplitude * 20));
  }
  const double omega = 2 * pi * frequency;
  for (const double t : {-0.3, 0.0, 0.123, 0.9})
    check_rate(p, t, amplitude * omega * omega * omega, mean + 20 * amplitude);
}

TEST_CASE("a cycle starts at `from`, is at `to` after half a period and back after one") {
  const double from = 100, to = 120, period = 0.4;
  const std::vector<double> data = {2, from, to, period};
  const Program p = program(data);
  CHECK(p(0) == from);
  CHECK(p.rate(0) == 0);
  // cos near its extremes loses no more than the rounding of 1 − cos.
  CHECK(std::abs(p(period / 2) - to) <= 4 * epsilon * to);
  CHECK(std::abs(p(period) - from) <= 4 * epsilon * to);
  CHECK(std::abs(p(period / 4) - 0.5 * (from + to)) <= 8 * epsilon * to);
  const double omega = 2 * pi / period;
  for (const double t : {0.0, 0.05, 0.13, 0.3})
    check_rate(p, t, 0.5 * (to - from) * omega * omega * omega, to);
}

TEST_CASE("a ramp is linear for its duration and constant outside") {
  const double from = -1, to = 4, duration = 2;
  const std::vector<double> data = {3, from, to, duration};
  const Program p = program(data);
  CHECK(p(-1) == from);
  CHECK(p(0) == from);
  CHECK(p(0.5) == 0.25);  // halves and quarters are exact
  CHECK(p(1) == 1.5);
  CHECK(p(2) == to);
  CHECK(p(17) == to);
  for (const double t : {0.3, 1.0, 1.7}) check_rate(p, t, 0, 5);
  // At corners the rate is the one from the right.
  CHECK(p.rate(-0.1) == 0);
  CHECK(p.rate(0) == 2.5);
  CHECK(p.rate(2) == 0);
}

TEST_CASE("a table interpolates between its points and is constant outside") {
  const std::vector<double> data = {4, 1, 10, 2, 30, 4, 20, 8, 20};
  const Program p = program(data);
  CHECK(p(0) == 10);
  CHECK(p(1) == 10);
  CHECK(p(1.25) == 15);
  CHECK(p(2) == 30);
  CHECK(p(3) == 25);
  CHECK(p(4) == 20);
  CHECK(p(6) == 20);
  CHECK(p(8) == 20);
  CHECK(p(100) == 20);
  for (const double t : {0.5, 1.5, 3.1, 5.0, 9.0}) check_rate(p, t, 0, 30);
  CHECK(p.rate(1) == 20);
  CHECK(p.rate(2) == -5);
  CHECK(p.rate(4) == 0);
  CHECK(p.rate(8) == 0);
}

TEST_CASE("a table of one point is a constant") {
  const std::vector<double> data = {4, 1, 10};
  for (const double t : {0.0, 1.0, 2.0}) {
    CHECK(program(data)(t) == 10);
    CHECK(program(data).rate(t) == 0);
  }
}

TEST_CASE("a table with a jump has the later value at the jump") {
  const std::vector<double> data = {4, 0, 1, 1, 1, 1, 5, 2, 5};
  const Program p = program(data);
  CHECK(p(0.999) == 1);
  CHECK(p(1) == 5);
  CHECK(p.rate(1) == 0);
  CHECK(p(1.5) == 5);
}

namespace {

// Amplitude 2 about a mean of 1, so that a value is 1 + 2 w.
double wave_of(const Program& p, double time) { return 0.5 * (p(time) - 1); }

}  // namespace

TEST_CASE("the rate of each drive is the derivative of its value") {
  // 100 Hz at most; the third derivative of a sine of amplitude 2 is 2 (2 pi f)^3, of pulses and rises a few
  // times more, since their products add derivatives of each.
  const std::vector<std::vector<double>> drives = {{5, 1, 2, 0.05, 80, 0.3},
                                                   {6, 1, 2, 0.05, 20, 100, 0.4, 0},
                                                   {6, 1, 2, 0.05, 20, 100, 0.4, 1},
                                                   {7, 1, 2, 0.2, 0.02},
                                                   {8, 1, 2, 0.2, 30},
                                                   {9, 1, 0.7, 0.05, 20, 5, 0.1, 2, 4, 6, 1},
                                                   {10, 1, 2, 0.05, 0.4, 50, 0, 100, 0.2}};
  for (const auto& data : drives) {
    const Program p = program(data);
    INFO("kind " << data[0]);
    for (const double t : {0.013, 0.049, 0.11, 0.187, 0.21, 0.333, 0.377}) check_rate(p, t, 30 * 2.5e8, 10);
  }
}

TEST_CASE("drives begin at the mean, rise smoothly and end where they should") {
  for (const auto& data : std::vector<std::vector<double>>{
           {5, 1, 2, 0.05, 80, 0.3}, {6, 1, 2, 0.05, 20, 100, 0.4, 0}, {9, 1, 0.7, 0.05, 20, 5, 0.1, 2}}) {
    const Program p = program(data);
    INFO("kind " << data[0]);
    CHECK(p(0) == 1);
    CHECK(p(-1) == 1);
    CHECK(std::abs(p.rate(0)) < 1e-12);
  }
  const std::vector<double> chirp_data = {6, 1, 2, 0.05, 20, 100, 0.4, 0},
                            sweep_data = {10, 1, 2, 0, 0.4, 50, 0, 100, 0.2};
  const Program chirp = program(chirp_data), sweep = program(sweep_data);
  CHECK(chirp(0.4) == Approx(1).margin(1e-12));
  CHECK(chirp(0.41) == 1);
  CHECK(sweep(0.401) == 1);
}

TEST_CASE("a chirp has the cycles of its mean frequency, and a logarithmic one equal cycles per octave") {
  // Zeros at whole numbers of half cycles: after T/2 a linear chirp from 20 to 100 Hz has made 20 T/2 + 80
  // T/8 cycles.
  const std::vector<double> linear_data = {6, 1, 2, 0, 20, 100, 0.4, 0},
                            octaves_data = {6, 1, 2, 0, 25, 100, 0.4, 1};
  const Program linear = program(linear_data), octaves = program(octaves_data);
  CHECK(wave_of(linear, 0.2) == Approx(std::sin(2 * pi * (20 * 0.2 + 0.5 * 80 / 0.4 * 0.04))).margin(1e-9));
  // From 25 to 50 Hz in the first half: (50 - 25) T / ln 4 cycles.
  CHECK(wave_of(octaves, 0.2) == Approx(std::sin(2 * pi * 25 * 0.4 / std::log(4.0))).margin(1e-9));
}

TEST_CASE("pulses have their crest in the middle, and that of Ricker has no mean") {
  const std::vector<double> bell_data = {7, 1, 2, 0.2, 0.02}, ricker_data = {8, 1, 2, 0.2, 30};
  const Program bell = program(bell_data), ricker = program(ricker_data);
  CHECK(wave_of(bell, 0.2) == 1);
  CHECK(wave_of(bell, 0.22) == Approx(std::exp(-0.5)).epsilon(1e-12));
  CHECK(wave_of(ricker, 0.2) == 1);
  double mean = 0;
  for (int k = 0; k < 4000; ++k) mean += wave_of(ricker, 1e-4 * (k + 0.5)) / 4000;
  CHECK(std::abs(mean) < 1e-12);
}
