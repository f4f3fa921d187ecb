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

TEST_CASE("solid_fraction: shells around a sphere, and discs", "[probe]") {
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
}

TEST_CASE("solid_fraction: cylinders, their slices and shells, and slices of spheres", "[probe]") {
  Simulation s(pressed_spheres());
  run(s, 1000);
  const auto in_bins = [&](double region, double bins, double along, double from) {
    Values values = {{"region", {region}},
                     {"centre", {0.02, 0.019, 0.021}},
                     {"radius", {0.012}},
                     {"bins", {bins}},
                     {"along", {along}}};
    if (region == 3) values.insert(values.end(), {"length", {0.02}});
    const Sampled bin = sample(s, "solid_fraction", values);
    double sum = 0;
    for (int k = int(from); k <= int(bins); ++k) {
      const std::string number = bins == 1 ? "" : "_" + std::to_string(k);
      sum += bin["solid_fraction" + number] * bin["volume" + number];
    }
    return sum;
  };
  const double cylinder = in_bins(3, 1, 0, 1);
  CHECK(in_bins(3, 5, 2, 1) == Approx(cylinder).epsilon(1e-12));
  CHECK(in_bins(3, 4, 3, 1) == Approx(cylinder).epsilon(1e-12));
  CHECK(in_bins(2, 5, 0, 1) == Approx(in_bins(2, 1, 0, 1)).epsilon(1e-12));
  // The shell of the outer half of the radius, by points of the cylinder at random.
  std::mt19937_64 generator(14);
  std::uniform_real_distribution<double> across(-0.012, 0.012), z(0.011, 0.031);
  const double shell = std::numbers::pi * 0.75 * 0.012 * 0.012 * 0.02;
  constexpr int points = 40000;
  int tried = 0, inside = 0;
  while (tried < points) {
    const double x = across(generator), y = across(generator), away = std::hypot(x, y);
    if (away >= 0.012 || away < 0.006) continue;
    ++tried;
    const Vec3 point = {0.02 + x, 0.019 + y, z(generator)};
    for (std::size_t i = 0; i < s.particles().size(); ++i)
      inside += norm(position(s, i) - point) < s.particles().radius()[i];
  }
  const double exact = in_bins(3, 2, 3, 2) / shell;
  // Four standard deviations of a share of the points.
  CHECK(std::abs(exact - double(inside) / points) < 4 * std::sqrt(exact * (1 - exact) / points));
}

TEST_CASE("solid_fraction: in a cone, as the walls of a funnel enclose it", "[probe]") {
  // A sphere of radius 1 m has its lowest point in the lower end of a funnel with half angle arcsin 0.6 and
  // touches its wall: the wall is at 1/0.8 from the axis at the height of the centre.
  const double slope = 0.75, at_centre = 1.25;
  Scene sc = scene(3, 1e-4, {body(1, 1, 1, {{2, 3, 4}}), body(2, 1, 1, {{2, 3, 7.5}})},
                   {{"normal_stiffness", {1e4}}, {"normal_damping", {0}}});
  const Simulation s(sc);
  const Values funnel = {{"region", {4}},
                         {"centre", {2, 3, 4.5}},
                         {"radius_low", {at_centre - slope}},
                         {"radius_high", {at_centre + 2 * slope}},
                         {"length", {3}}};
  const double volume = std::numbers::pi * (0.25 + 0.5 * 2.75 + 2.75 * 2.75);
  const double sphere = 4 * std::numbers::pi / 3;
  const Sampled whole = sample(s, "solid_fraction", funnel);
  CHECK(whole["volume"] == Approx(volume));
  CHECK(whole["solid_fraction"] == Approx(sphere / volume));
  Values in_bins = funnel;
  in_bins.insert(in_bins.end(), {{"bins", {3}}, {"along", {2}}});
  const Sampled bins = sample(s, "solid_fraction", in_bins);
  CHECK(bins["solid_fraction_1"] * bins["volume_1"] == Approx(sphere / 2));
  CHECK(bins["solid_fraction_2"] * bins["volume_2"] == Approx(sphere / 2));
  CHECK(bins["solid_fraction_3"] == 0);
  CHECK(bins["volume_1"] + bins["volume_2"] + bins["volume_3"] == Approx(volume));
}
