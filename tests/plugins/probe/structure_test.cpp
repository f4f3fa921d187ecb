#include "error_line.hpp"
#include "probe_support.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("structure: a periodic cubic lattice has its shells of neighbours in g(r)", "[probe]") {
  std::vector<Body> bodies;
  for (int i = 0; i < 216; ++i)
    bodies.push_back(body(i + 1, 0.4, 1, {double(i % 6), double(i / 6 % 6), double(i / 36)}));
  Scene sc = scene(3, 1e-4, bodies, elastic_law);
  add_boundary(sc, "periodic", {{"lower", {-0.5, -0.5, -0.5}}, {"upper", {5.5, 5.5, 5.5}}, {"axes", {6}}});
  const Simulation s(sc);
  // Distances 1, √2, √3, 2 m with 6, 12, 8 and 6 neighbours; density 1/m³; classes of 0.2 m.
  const Sampled row = sample(s, "structure", {{"largest", {2.2}}, {"classes", {11}}});
  const auto shell = [](double from) {
    return 4 * std::numbers::pi / 3 * (std::pow(from + 0.2, 3) - std::pow(from, 3));
  };
  // Distances of exactly 1 and 2 m fall into the class below or above by round-off of its edges.
  CHECK(row["g_5"] * shell(0.8) + row["g_6"] * shell(1.0) == Approx(6));
  CHECK(row["g_8"] == Approx(12 / shell(1.4)));
  CHECK(row["g_9"] == Approx(8 / shell(1.6)));
  CHECK(row["g_10"] * shell(1.8) + row["g_11"] * shell(2.0) == Approx(6));
  CHECK(row["g_7"] == 0);
  CHECK(row["coordination_number"] == 0);
  CHECK(row["rattlers"] == 216);
}

TEST_CASE("structure: points without order have g(r) = 1 up to the sides of a window", "[probe]") {
  for (const int dimension : {2, 3}) {
    std::mt19937_64 generator(13);
    std::uniform_real_distribution<double> place(0, 10);
    std::vector<Body> bodies;
    for (int i = 0; i < 1500; ++i)
      bodies.push_back(body(i + 1, 1e-6, 1,
                            {place(generator), place(generator), dimension == 3 ? place(generator) : 0}, {},
                            {}, dimension));
    const Simulation s(scene(dimension, 1e-4, bodies, elastic_law));
    const Sampled row = sample(
        s, "structure",
        {{"region", {1}}, {"lower", {0, 0, 0}}, {"upper", {10, 10, 10}}, {"largest", {8}}, {"classes", {8}}});
    std::vector<double> pairs(8, 0);
    for (std::size_t a = 0; a < bodies.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (const double r = norm(bodies[a].position - bodies[b].position); r < 8) pairs[std::size_t(r)] += 1;
    for (int k = 1; k <= 8; ++k) {
      INFO(dimension << " " << k << " " << pairs[std::size_t(k - 1)]);
      // Numbers of pairs scatter by their roots, 3.3 times of which one in a thousand exceeds.
      CHECK(std::abs(row["g_" + std::to_string(k)] - 1) < 3.3 / std::sqrt(pairs[std::size_t(k - 1)]));
    }
  }
}

TEST_CASE("structure: rattlers are taken away until none is left", "[probe]") {
  // A ring of four discs that touch, with a tail of three: the tail goes one by one.
  std::vector<Body> bodies;
  const double d = 1.99;
  for (const Vec3& place : {Vec3{0, 0, 0}, Vec3{d, 0, 0}, Vec3{d, d, 0}, Vec3{0, d, 0}, Vec3{2 * d, 0, 0},
                            Vec3{3 * d, 0, 0}, Vec3{4 * d, 0, 0}})
    bodies.push_back(body(std::int64_t(bodies.size()) + 1, 1, 1, place, {}, {}, 2));
  const Simulation s(scene(2, 1e-4, bodies, elastic_law));
  const Sampled row = sample(s, "structure");
  CHECK(row["bodies"] == 7);
  CHECK(row["coordination_number"] == Approx(14.0 / 7));
  CHECK(row["rattlers"] == 3);
  CHECK(row["coordination_without_rattlers"] == Approx(2));
  // With three contacts needed, nothing is left.
  const Sampled none = sample(s, "structure", {{"rattler_below", {3}}});
  CHECK(none["rattlers"] == 7);
  CHECK(std::isnan(none["coordination_without_rattlers"]));
}

TEST_CASE("structure: g(r) beyond half of a period is refused", "[probe]") {
  Scene sc = scene(2, 1e-4, {body(1, 0.1, 1, {{0.5, 0.5, 0}}, {}, {}, 2)}, elastic_law);
  add_boundary(sc, "periodic", {{"lower", {0, 0, 0}}, {"upper", {1, 1, 0}}, {"axes", {3}}});
  const Simulation s(sc);
  CHECK_THAT(error_line([&] {
               sample(s, "structure", {{"largest", {0.6}}});
             }),
             Catch::Contains("largest is more than half of the period along x"));
}
