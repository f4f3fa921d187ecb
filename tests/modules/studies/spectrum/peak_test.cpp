#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/spectrum/peak.hpp>

using namespace scree::spectrum;

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

TEST_CASE("the shape of a standing wave tells its wavelengths, from either end", "[spectrum]") {
  constexpr double from_node = 0, from_antinode = std::numbers::pi / 2;
  for (const int count : {8, 10, 14, 40}) {
    CAPTURE(count);
    for (const double wavelengths : {0.25, 0.75, 1.25, 1.75})
      for (const double phase : {from_node, from_antinode}) {
        CAPTURE(wavelengths, phase);
        CHECK(mode_shape(standing_wave(wavelengths, phase, count)).wavelengths == wavelengths);
      }
    // Of the higher ones the outer layers, half a layer from a node, move more than half as far as the
    // largest.
    for (const double wavelengths : {0.5, 1.0, 1.5, 2.0}) {
      CAPTURE(wavelengths);
      CHECK(mode_shape(standing_wave(wavelengths, from_node, count)).wavelengths == wavelengths);
    }
  }
}

// A packing of 2000 spheres between a fixed lower and a driven upper wall, which moves by itself.
TEST_CASE("half a wave below a driven wall is none of a quarter", "[spectrum]") {
  std::vector<std::complex<double>> layers;
  for (const auto& [amplitude, phase] : std::vector<std::pair<double, double>>{{0.393, 1.592},
                                                                               {1.009, 1.665},
                                                                               {1.591, 1.655},
                                                                               {2.197, 1.666},
                                                                               {2.782, 1.672},
                                                                               {2.683, 1.711},
                                                                               {3.057, 1.737},
                                                                               {2.737, 1.786},
                                                                               {2.580, 1.833},
                                                                               {2.136, 1.917},
                                                                               {1.703, 2.103},
                                                                               {1.167, 2.325}})
    layers.push_back(std::polar(amplitude, phase));
  CHECK(mode_shape(layers).wavelengths == 0.5);
}

// u = sin(kx) / sin(k) of a wall that is driven by 1 and a fixed one, cos(kx) / cos(k) with a free end in its
// place; k is complex, by the quality.
TEST_CASE("the motion of the driven wall changes no name, with a fixed and a free end", "[spectrum]") {
  for (const int count : {8, 12, 20})
    for (const double quality : {5.0, 10.0, 100.0})
      for (const int quarters : {1, 2, 3, 4, 5, 6}) {
        const bool is_fixed = quarters % 2 == 0;
        // From below to above the resonance, by a tenth of its width.
        for (const double beside : {-0.1, 0.1}) {
          const std::complex<double> k =
              0.5 * std::numbers::pi * quarters * (1 + beside / quality) * std::complex(1.0, -0.5 / quality);
          std::vector<std::complex<double>> layers;
          for (int j = 0; j < count; ++j) {
            const double x = (j + 0.5) / count;
            layers.push_back(is_fixed ? std::sin(k * x) / std::sin(k) : std::cos(k * x) / std::cos(k));
          }
          CAPTURE(count, quality, quarters, beside);
          CHECK(mode_shape(layers).wavelengths == 0.25 * quarters);
        }
      }
}

TEST_CASE("half waves between free ends have antinodes at both", "[spectrum]") {
  constexpr double from_antinode = std::numbers::pi / 2;
  for (const double wavelengths : {0.5, 1.0, 1.5})
    CHECK(mode_shape(standing_wave(wavelengths, from_antinode)).wavelengths == wavelengths);
}

TEST_CASE("a shape is in the phase in which the layers move most, its largest 1", "[spectrum]") {
  auto layers = standing_wave(0.25, 0);
  const std::vector<double> shape = mode_shape(layers).displacement;
  for (std::size_t k = 0; k < layers.size(); ++k)
    CHECK(shape[k] == Approx(std::abs(layers[k]) / std::abs(layers.back())).epsilon(1e-12));
  // A part in quadrature changes nothing but round-off.
  for (auto& u : layers) u += std::complex<double>(0, 0.3) * u;
  for (std::size_t k = 0; k < layers.size(); ++k)
    CHECK(mode_shape(layers).displacement[k] == Approx(shape[k]).epsilon(1e-12));
}

TEST_CASE("a wave of which less than a quarter comes back has no wavelengths", "[spectrum]") {
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

TEST_CASE("layers at rest have no shape and no wavelengths", "[spectrum]") {
  const ModeShape shape = mode_shape(std::vector<std::complex<double>>(5, 0.0));
  CHECK(shape.displacement == std::vector<double>(5, 0.0));
  CHECK(std::isnan(shape.wavelengths));
}

// A mode of Q 20 and one of a third of its height, 0.8 or 0.5 of its width above: the fit finds both, |H| has
// one maximum.
TEST_CASE("a shoulder is a peak without a name", "[spectrum]") {
  const double second = GENERATE(104.0, 102.5);
  const auto pole = [](double f, double f0, double w, double height) {
    return height * f0 * w / std::complex(f0 * f0 - f * f, f * w);
  };
  MethodSpectrum spectrum;
  spectrum.method = "linear";
  spectrum.columns.resize(7);
  for (double f = 80; f < 120; f += 0.25) {
    spectrum.frequencies.push_back(f);
    const std::complex<double> h = pole(f, 100, 5, 1) + pole(f, second, 5, 0.33);
    spectrum.columns[0].response.push_back(h);
    for (std::size_t layer = 1; layer < 7; ++layer)
      spectrum.columns[layer].response.push_back(h *
                                                 std::sin(0.5 * std::acos(-1.0) * (double(layer) - 0.5) / 6));
  }
  std::vector<ObservedColumn> observed(7);
  observed[0].unit = "m";
  for (std::size_t layer = 1; layer < 7; ++layer) observed[layer].of_shape = true;
  const auto peaks = peaks_in({spectrum}, observed);
  REQUIRE(peaks.size() == 2);
  CHECK(peaks[1].mode.frequency == Approx(second).epsilon(1e-6));
  CHECK(name_of(peaks[0]) == "λ/4");
  CHECK(name_of(peaks[1]).empty());
}
