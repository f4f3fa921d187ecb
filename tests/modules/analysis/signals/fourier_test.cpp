#include "fourier.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>

using namespace scree::signals;

TEST_CASE("the transform of real values is its sum", "[fourier]") {
  for (const std::size_t count : {1, 2, 5, 12, 97, 128}) {
    CAPTURE(count);
    Fourier fourier(count);
    for (int round = 0; round < 2; ++round) {  // a transform overwrites its input
      std::vector<double> x;
      for (std::size_t j = 0; j < count; ++j) x.push_back(std::sin(1.7 * double(j * j) + round) + 0.3);
      std::copy(x.begin(), x.end(), fourier.values().begin());
      const auto transform = fourier.transform();
      REQUIRE(transform.size() == count / 2 + 1);
      for (std::size_t k = 0; k < transform.size(); ++k) {
        std::complex<double> sum = 0;
        for (std::size_t j = 0; j < count; ++j)
          sum += x[j] * std::polar(1.0, -2 * std::numbers::pi * double(j * k % count) / double(count));
        CHECK(std::abs(transform[k] - sum) < 1e-13);  // round-off of up to 128 terms
      }
    }
  }
}

TEST_CASE("a transform without values is refused", "[fourier]") {
  CHECK_THROWS_WITH(Fourier(0), "spectrum: 0 values; give 1 to 2147483647");
}

TEST_CASE("the window of Hann begins at 0 and has the mean 1/2", "[fourier]") {
  const std::vector<double> window = hann(8);
  const double expected[] = {0, 0.5 - std::sqrt(0.125), 0.5, 0.5 + std::sqrt(0.125), 1};
  for (std::size_t j = 0; j < 5; ++j) CHECK(std::abs(window[j] - expected[j]) < 1e-15);
  for (std::size_t j = 1; j < 4; ++j) CHECK(std::abs(window[8 - j] - window[j]) < 1e-15);
}
