#include "oscillator.hpp"
#include "signals.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/signals/transfer_function.hpp>

using namespace scree::signals;
using scree::test::equal_times;
using scree::test::Oscillator;

namespace {

constexpr double oscillator_step = 0.001, oscillator_frequency = 60, oscillator_quality = 10;
const Oscillator oscillator(oscillator_frequency, oscillator_quality, oscillator_step);

std::vector<double> white_values(std::size_t count, double sigma, std::mt19937_64& random) {
  std::normal_distribution<double> gauss(0, sigma);
  std::vector<double> values(count);
  for (double& value : values) value = gauss(random);
  return values;
}

std::vector<double> sum(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] += b[k];
  return a;
}

// Largest |H''| of the oscillator (1/Hz^2), by differences of 0.1 Hz.
double curvature() {
  double largest = 0;
  for (double f = 1; f < 499; f += 0.1)
    largest = std::max(largest, std::abs(oscillator.transfer(f - 0.1) - 2.0 * oscillator.transfer(f) +
                                         oscillator.transfer(f + 0.1)) /
                                    0.01);
  return largest;
}

// Largest response of a response's spectrum, for scale.
const double resonance_height = std::abs(oscillator.transfer(oscillator_frequency));

}  // namespace

TEST_CASE("a chirp and a pulse that end at rest give the exact transfer function", "[transfer_function]") {
  constexpr std::size_t count = 4000;  // exp(-pi f t / Q) falls to 1e-16 in 2 s
  std::vector<double> pulse(count), chirp(count);
  for (std::size_t k = 0; k < 1000; ++k) {
    const double t = oscillator_step * double(k);
    pulse[k] = k < 5 ? std::pow(std::sin(std::numbers::pi * (double(k) + 1) / 6), 2) : 0;
    chirp[k] =
        std::sin(2 * std::numbers::pi * (10 * t + 120 * t * t)) * std::pow(std::sin(std::numbers::pi * t), 2);
  }
  for (const auto& drive : {pulse, chirp}) {
    const auto transfer =
        transfer_function(equal_times(count, oscillator_step), drive, oscillator.response(drive), 0);
    CHECK(transfer.resolution == Approx(0.25));
    CHECK(transfer.segments == 1);
    double largest = 0;
    for (std::size_t k = 80; k < 600; ++k) {  // 20 Hz to 150 Hz, where both drive
      largest = std::max(largest, std::abs(transfer.h1[k] - oscillator.transfer(transfer.frequency(k))));
      CHECK(transfer.coherence[k] == Approx(1));
      CHECK(std::isnan(transfer.error[k]));
    }
    CHECK(largest <
          1e-11 *
              resonance_height);  // round-off of transforms, 1e-16 of the largest X, here 1e3 of the least
  }
}

TEST_CASE("a response that is cut off changes the transfer function by no more than is stated",
          "[transfer_function]") {
  std::vector<double> pulse(4000);
  pulse[0] = 1;
  const auto whole = oscillator.response(pulse);
  constexpr std::size_t cut = 300;
  double beyond = 0;
  for (std::size_t k = cut; k < whole.size(); ++k) beyond += std::abs(whole[k]);
  const std::span<const double> x(pulse), y(whole);
  const auto transfer = transfer_function(equal_times(cut, oscillator_step), x.first(cut), y.first(cut), 0);
  double largest = 0;
  for (std::size_t k = 0; k < transfer.h1.size(); ++k)
    largest = std::max(largest, std::abs(transfer.h1[k] - oscillator.transfer(transfer.frequency(k))));
  CHECK(largest < beyond);  // |X| = 1 in the sums of samples
  CHECK(largest > 0.3 * beyond);
}

TEST_CASE("driven by noise, the bias is below the leakage of the window", "[transfer_function]") {
  std::mt19937_64 random(3);
  const auto drive = white_values(2000000, 1, random);
  const auto response = oscillator.response(drive);
  for (const std::size_t segment : {500u, 2000u}) {
    const auto transfer =
        transfer_function(equal_times(drive.size(), oscillator_step), drive, response, segment);
    const double length = oscillator_step * double(segment), bound = curvature() / (6 * length * length);
    double largest = 0;
    for (std::size_t k = 2; k + 2 < transfer.h1.size(); ++k) {
      const auto exact = oscillator.transfer(transfer.frequency(k));
      const double scatter = transfer.error[k] * std::abs(exact);
      CHECK(std::abs(transfer.h1[k] - exact) <
            bound + 6 * scatter);  // of both parts; once in 1e7 cases by chance
      largest = std::max(largest, std::abs(transfer.h1[k] - exact) / bound);
    }
    CHECK(largest > 0.1);  // the bound is not idle
  }
}

TEST_CASE("with noise in the response, errors cover the deviation of amplitude and phase",
          "[transfer_function]") {
  std::mt19937_64 random(8);
  constexpr std::size_t segment = 4096, count = 40 * segment;
  const auto drive = white_values(count, 1, random);
  const auto clean = oscillator.response(drive);
  const auto response = sum(clean, white_values(count, 0.5 * std::abs(oscillator.transfer(80)), random));
  const auto transfer = transfer_function(equal_times(count, oscillator_step), drive, response, segment);
  CHECK(transfer.segments == 79);
  CHECK(transfer.averages == Approx(79 / (1 + 2.0 / 36 * 78 / 79)).epsilon(1e-6));
  int covered = 0, cases = 0;
  for (std::size_t k = 4; k + 4 < transfer.h1.size(); k += 3) {
    const auto exact = oscillator.transfer(transfer.frequency(k));
    if (transfer.coherence[k] < 0.3) continue;  // the formula is of first order in the error
    covered += std::abs(std::abs(transfer.h1[k] / exact) - 1) < transfer.error[k];
    covered += std::abs(std::arg(transfer.h1[k] / exact)) < transfer.error[k];
    cases += 2;
  }
  REQUIRE(cases > 150);
  // The share of so many cases is known to sqrt(0.22 / cases).
  CHECK(double(covered) / cases == Approx(0.68).margin(0.05 + std::sqrt(0.22 / cases)));
}

TEST_CASE("noise in the drive biases h1 by the coherence, and h2 not", "[transfer_function]") {
  std::mt19937_64 random(9);
  constexpr std::size_t segment = 1000, count = 400 * segment;
  const auto drive = white_values(count, 1, random);
  const auto measured = sum(drive, white_values(count, 0.7, random));
  const auto transfer =
      transfer_function(equal_times(count, oscillator_step), measured, oscillator.response(drive), segment);
  double h1 = 0;
  std::complex<double> h2 = 0;
  double cases = 0;
  for (std::size_t k = 70; k < 400; ++k, ++cases) {  // beside the peak, where leakage is small
    const auto exact = oscillator.transfer(transfer.frequency(k));
    h1 += std::abs(transfer.h1[k] / exact), h2 += transfer.h2[k] / exact;
  }
  // 330 entries with errors of sqrt(0.49 / (2 * 760)) each: 0.1 %.
  CHECK(h1 / cases == Approx(1 / 1.49).epsilon(0.01));
  CHECK(std::abs(h2 / cases - 1.0) < 0.01);
}

TEST_CASE("a transfer function of unequal steps or too little is refused", "[transfer_function]") {
  const std::vector<double> x(100, 1.0);
  CHECK_THROWS_WITH(
      transfer_function(scree::test::random_times(100, 1, 1), x, x, 0),
      Catch::StartsWith("transfer function: samples are up to ") &&
          Catch::EndsWith(" steps away from equal steps; put the records on equal steps first"));
  CHECK_THROWS_AS(transfer_function(equal_times(100, 1), x, x, 200), scree::Error);
  CHECK_THROWS_AS(transfer_function(equal_times(99, 1), x, x, 10), scree::Error);
  const std::vector<double> nothing(100);
  const auto transfer = transfer_function(equal_times(100, 1), nothing, x, 20);
  CHECK(transfer.h1[3] == 0.0);
  CHECK(std::isinf(transfer.error[3]));
}
