#include <cmath>
#include <numbers>
#include <random>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/signals/band_noise.hpp>

using namespace scree::signals;

TEST_CASE("noise of a band has nothing outside, and an rms of 1 with both parts of each sine",
          "[band_noise]") {
  for (const std::size_t count : {4000u, 4001u}) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> gauss;
    const auto noise = band_noise(count, 100, 600, [&] { return gauss(random); });
    REQUIRE(noise.size() == count);
    double square = 0;
    for (const double x : noise) square += x * x / double(count);
    CHECK(square == Approx(1).margin(4 * std::sqrt(1 / 501.0)));  // of 1002 deviates
    double sines = 0, cosines = 0, outside = 0;
    for (std::size_t k = 1; k < count / 2; k += 7) {
      double sine = 0, cosine = 0;
      for (std::size_t j = 0; j < count; ++j) {
        const double angle = 2 * std::numbers::pi * double(k * j % count) / double(count);
        sine += noise[j] * std::sin(angle), cosine += noise[j] * std::cos(angle);
      }
      const bool within = k >= 100 && k <= 600;
      (within ? sines : outside) += sine * sine;
      (within ? cosines : outside) += cosine * cosine;
    }
    CHECK(outside < 1e-18 * sines);
    CHECK(sines / cosines == Approx(1).margin(4 * std::sqrt(4 / 72.0)));  // of 72 deviates each
  }
  CHECK_THROWS_WITH(band_noise(100, 0, 10, [] { return 0.0; }), Catch::StartsWith("noise: no band from 0 "));
  CHECK_THROWS_AS(band_noise(100, 10, 50, [] { return 0.0; }), scree::Error);
}
