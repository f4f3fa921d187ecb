#include "error_line.hpp"
#include "pressed_spheres.hpp"
#include "probe_support.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("solid_fraction: bins hold all of the bodies, whatever they cut", "[probe]") {
  Simulation s(pressed_spheres());
  run(s, 1000);
  double bodies = 0;
  for (std::size_t i = 0; i < s.particles().size(); ++i)
    bodies += 4.0 / 3 * std::numbers::pi * std::pow(s.particles().radius()[i], 3);
  const double volume = s.lengths()[0] * s.lengths()[1] * s.lengths()[2];
  CHECK(sample(s, "solid_fraction")["solid_fraction"] == Approx(bodies / volume).epsilon(1e-13));
  const Sampled layers = sample(s, "solid_fraction", {{"bins", {9}}, {"along", {1}}});
  double sum = 0, space = 0;
  for (int k = 1; k <= 9; ++k) {
    sum += layers["solid_fraction_" + std::to_string(k)] * layers["volume_" + std::to_string(k)];
    space += layers["volume_" + std::to_string(k)];
  }
  CHECK(sum == Approx(bodies).epsilon(1e-12));
  CHECK(space == Approx(volume).epsilon(1e-13));
}

TEST_CASE("solid_fraction: a box within a packing, by points at random", "[probe]") {
  Simulation s(pressed_spheres());
  run(s, 1000);
  const Values inner = {{"region", {1}}, {"lower", {0.01, 0.012, 0.008}}, {"upper", {0.03, 0.025, 0.033}}};
  const double exact = sample(s, "solid_fraction", inner)["solid_fraction"];
  std::mt19937_64 generator(12);
  std::uniform_real_distribution<double> x(0.01, 0.03), y(0.012, 0.025), z(0.008, 0.033);
  constexpr int points = 40000;
  int inside = 0;  // in how many bodies; overlaps count twice
  for (int n = 0; n < points; ++n) {
    const Vec3 point = {x(generator), y(generator), z(generator)};
    for (std::size_t i = 0; i < s.particles().size(); ++i)
      inside += norm(position(s, i) - point) < s.particles().radius()[i];
  }
  // Four standard deviations of a share of 40 000 points.
  CHECK(std::abs(exact - double(inside) / points) < 4 * std::sqrt(exact * (1 - exact) / points));
}

TEST_CASE("solid_fraction: shells around a sphere, discs, and regions without a closed form", "[probe]") {
  const Simulation s(
      scene(3, 1e-4, {body(1, 1, 1, {{0, 0, 0}})}, {{"normal_stiffness", {1e4}}, {"normal_damping", {0}}}));
  const Sampled shells =
      sample(s, "solid_fraction",
             {{"region", {2}}, {"centre", {0, 0, 0}}, {"radius", {2}}, {"bins", {4}}, {"along", {3}}});
  CHECK(shells["solid_fraction_1"] == Approx(1));
  CHECK(shells["solid_fraction_2"] == Approx(1));
  CHECK(shells["solid_fraction_3"] == 0);
  const Simulation flat(scene(2, 1e-4, {body(1, 1, 1, {{0, 0, 0}}, {}, {}, 2)},
                              {{"normal_stiffness", {1e4}}, {"normal_damping", {0}}}));
  CHECK(sample(flat, "solid_fraction",
               {{"region", {1}}, {"lower", {0, 0, 0}}, {"upper", {2, 2, 0}}})["solid_fraction"] ==
        Approx(std::numbers::pi / 16));
  CHECK_THAT(error_line([&] {
               sample(s, "solid_fraction",
                      {{"region", {3}}, {"centre", {0, 0, 0}}, {"radius", {2}}, {"length", {1}}});
             }),
             Catch::Contains("has no closed form"));
}
