#include "mode_shape.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

using namespace scree::sound;

namespace {

// sin(2π w x + φ) at the middles of layers, x from 0 to 1, all turned by one phase.
std::vector<std::complex<double>> standing_wave(double wavelengths, double phase, int count = 10) {
  std::vector<std::complex<double>> layers;
  for (int k = 0; k < count; ++k)
    layers.push_back(std::polar(3e-6, 2.2) *
                     std::sin(2 * std::numbers::pi * wavelengths * (k + 0.5) / count + phase));
  return layers;
}

}  // namespace

TEST_CASE("the shape of a standing wave tells its wavelengths, from either end", "[sound]") {
  constexpr double from_node = 0, from_antinode = std::numbers::pi / 2;
  for (const int count : {8, 10, 14, 40}) {
    CAPTURE(count);
    for (const double wavelengths : {0.25, 0.75, 1.25, 1.75})
      for (const double phase : {from_node, from_antinode}) {
        CAPTURE(wavelengths, phase);
        CHECK(mode_shape(standing_wave(wavelengths, phase, count)).wavelengths == wavelengths);
      }
    // Of the higher ones the outer layers, half a layer from a node, move more than half as far as the largest.
    for (const double wavelengths : {0.5, 1.0, 1.5, 2.0}) {
      CAPTURE(wavelengths);
      CHECK(mode_shape(standing_wave(wavelengths, from_node, count)).wavelengths == wavelengths);
    }
  }
}

TEST_CASE("a shape is in the phase in which the layers move most, its largest 1", "[sound]") {
  auto layers = standing_wave(0.25, 0);
  const std::vector<double> shape = mode_shape(layers).displacement;
  for (std::size_t k = 0; k < layers.size(); ++k)
    CHECK(shape[k] == Approx(std::abs(layers[k]) / std::abs(layers.back())).epsilon(1e-12));
  // A part in quadrature changes nothing but round-off.
  for (auto& u : layers) u += std::complex<double>(0, 0.3) * u;
  for (std::size_t k = 0; k < layers.size(); ++k)
    CHECK(mode_shape(layers).displacement[k] == Approx(shape[k]).epsilon(1e-12));
}

TEST_CASE("a wave of which less than a quarter comes back has no wavelengths", "[sound]") {
  for (const double returned : {0.0, 0.2, 0.3, 1.0}) {
    std::vector<std::complex<double>> layers;
    for (int k = 0; k < 10; ++k) {
      const double phase = 2 * std::numbers::pi * (k + 0.5) / 10;
      layers.push_back(std::polar(1.0, phase) + std::polar(returned, -phase));
    }
    CAPTURE(returned);
    CHECK(std::isnan(mode_shape(layers).wavelengths) == (returned < 0.25));
  }
}

TEST_CASE("layers at rest have no shape and no wavelengths", "[sound]") {
  const ModeShape shape = mode_shape(std::vector<std::complex<double>>(5, 0.0));
  CHECK(shape.displacement == std::vector<double>(5, 0.0));
  CHECK(std::isnan(shape.wavelengths));
}
