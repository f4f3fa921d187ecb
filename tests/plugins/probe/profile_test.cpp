#include "layer_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("profile: bins of a uniformly strained lattice move as the lattice does", "[profile]") {
  for (const int dimension : {2, 3})
    for (int axis = 0; axis < dimension; ++axis) {
      Simulation s(lattice_in_box(dimension, axis));
      Probe p = probe_of("profile", {{"bins", {5}}, {"axis", {double(axis)}}}, dimension);
      CHECK(sampled(p, s)["displacement_3"] == 0);
      run(s, 400);
      const Sampled row = sampled(p, s);
      REQUIRE(row.row.size() == 20);
      for (int k = 1; k <= 5; ++k) {
        const std::string n = std::to_string(k);
        const double height = 0.2 * k - 0.1, velocity = lattice_rate * (height - 0.5);
        CHECK(row["bodies_" + n] == 4);
        CHECK(row["position_" + n] == near(height + 0.4 * velocity, lattice_rounding));
        CHECK(row["velocity_" + n] == near(velocity, lattice_rounding));
        CHECK(row["displacement_" + n] == near(0.4 * velocity, lattice_rounding));
      }
    }
}

TEST_CASE("profile: between two heights, around a periodic face", "[profile]") {
  Scene sc = lattice(3, 1);
  for (Body& b : sc.bodies) b.velocity[1] = 4;
  add_boundary(sc, "periodic", {{"lower", {0, 0, 0}}, {"upper", {1, 1, 1}}, {"axes", {1}}});
  Simulation s(sc);
  Probe part = probe_of("profile", {{"bins", {2}}, {"low", {0.8}}, {"high", {1.2}}}, 3);
  Probe whole = probe_of("profile", {{"bins", {10}}, {"low", {-0.7}}, {"high", {0.3}}}, 3);
  sampled(part, s), sampled(whole, s);
  run(s, 200);
  const Sampled of_part = sampled(part, s), of_whole = sampled(whole, s);
  CHECK(of_part["bodies_1"] == 4);
  CHECK(of_part["bodies_2"] == 4);
  // Paths of up to 2 m.
  CHECK(of_part["position_1"] == near(0.9 + 0.8, 2 * lattice_rounding));
  CHECK(of_part["position_2"] == near(1.1 + 0.8, 2 * lattice_rounding));
  CHECK(of_part["displacement_2"] == near(0.8, 2 * lattice_rounding));
  for (int k = 1; k <= 10; ++k) {
    CHECK(of_whole["bodies_" + std::to_string(k)] == 2);
    CHECK(of_whole["position_" + std::to_string(k)] == near(-0.75 + 0.1 * k + 0.8, 2 * lattice_rounding));
  }
}

TEST_CASE("profile: goes on after a resume, and sampling leaves the motion as it is", "[profile]") {
  Simulation s(lattice_in_box(2, 1));
  const Values values = {{"bins", {5}}};
  Probe p = probe_of("profile", values, 2);
  sampled(p, s);
  run(s, 200);
  Probe q = resumed(p, "profile", values, s);
  run(s, 200);
  CHECK(sampled(q, s).row == sampled(p, s).row);
  CHECK(sampled(q, s)["displacement_1"] == near(-0.4 * 0.4 * lattice_rate, lattice_rounding));
  CHECK(leaves_the_motion("profile", {{"bins", {5}}}));
}

TEST_CASE("profile: bins without bodies and ends that do not fit are refused with a remedy", "[profile]") {
  const auto check = [](const Scene& sc, const Values& values) { sample(Simulation(sc), "profile", values); };
  Scene periodic = lattice(2, 1);
  add_boundary(periodic, "periodic", {{"lower", {0, 0, 0}}, {"upper", {1, 1, 1}}, {"axes", {1}}});
  CHECK_THROWS_WITH(check(lattice_in_box(2, 1), {{"bins", {20}}, {"low", {0}}, {"high", {0.99}}}),
                    Catch::Contains("has no body; give fewer bins"));
  CHECK_THROWS_WITH(check(lattice(2, 1), {{"bins", {5}}}), Catch::Contains("give low and high"));
  CHECK_THROWS_WITH(check(lattice(2, 1), {{"bins", {5}}, {"low", {1}}, {"high", {0}}}),
                    Catch::Contains("high is not above low"));
  CHECK_THROWS_WITH(check(periodic, {{"bins", {5}}, {"low", {0}}, {"high", {1.1}}}),
                    Catch::Contains("more than a period"));
  CHECK_THROWS_WITH(check(lattice_in_box(2, 1), {{"bins", {2.5}}}), Catch::Contains("no whole number"));
}
