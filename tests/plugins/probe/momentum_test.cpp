#include "probe_support.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include <scree/probes.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// Two bodies apart, with round numbers: m x × v of the first is (2, 1, −4) kg m²/s.
Scene pair_of_bodies(int dimension) {
  const bool flat = dimension == 2;
  return scene(
      dimension, 1e-3,
      {body(1, 0.5, 1, {{2, 0, flat ? 0.0 : 1.0}}, {{1, -2, 0}}, {{0, 0, 10}}, dimension),
       body(2, 1, 2, {{-3, 5, 0}}, {{0, 3, flat ? 0.0 : -1.0}}, {{flat ? 0.0 : 5.0, 0, 0}}, dimension)},
      frictional_law);
}

}  // namespace

TEST_CASE("momentum: translation and spin of spheres, about the origin", "[probe]") {
  const Sampled m = sample(Simulation(pair_of_bodies(3)), "momentum");
  CHECK(m.row.size() == 6);
  CHECK(m["momentum_x"] == 1);
  CHECK(m["momentum_y"] == -2 + 6);
  CHECK(m["momentum_z"] == -2);
  // First body (2, 1, −4) and 0.4·1·0.25·10 = 1 about z; second (−10, −6, −18) and 0.4·2·1·5 = 4 about x.
  CHECK(m["angular_momentum_x"] == Approx(2 - 10 + 4));
  CHECK(m["angular_momentum_y"] == Approx(1 - 6));
  CHECK(m["angular_momentum_z"] == Approx(-4 - 18 + 1));
}

TEST_CASE("momentum: discs have I = m R²/2 and one axis of rotation", "[probe]") {
  const Sampled m = sample(Simulation(pair_of_bodies(2)), "momentum");
  CHECK(m.row.size() == 3);
  CHECK(m["momentum_x"] == 1);
  CHECK(m["momentum_y"] == 4);
  CHECK(m["angular_momentum_z"] == Approx(-4 - 18 + 0.5 * 0.25 * 10));
}

TEST_CASE("momentum: another reference point changes the angular momentum by −x_0 × p", "[probe]") {
  const Simulation s(pair_of_bodies(3));
  const Sampled origin = sample(s, "momentum"), other = sample(s, "momentum", {{"about", {1, -2, 3}}});
  const Vec3 change = cross(Vec3{{-1, 2, -3}}, Vec3{{1, 4, -2}});
  CHECK(other["momentum_y"] == origin["momentum_y"]);
  CHECK(other["angular_momentum_x"] - origin["angular_momentum_x"] == Approx(change[0]));
  CHECK(other["angular_momentum_y"] - origin["angular_momentum_y"] == Approx(change[1]));
  CHECK(other["angular_momentum_z"] - origin["angular_momentum_z"] == Approx(change[2]));
}

TEST_CASE("momentum: without spins only translation contributes to the angular momentum", "[probe]") {
  Scene sc = scene(3, 1e-3, {body(1, 0.5, 2, {{0, 1, 0}}, {{3, 0, 0}})},
                   {{"normal_stiffness", {5000}}, {"normal_damping", {0}}});
  const Simulation s(sc);
  REQUIRE_FALSE(s.particles().has_spin());
  CHECK(sample(s, "momentum")["angular_momentum_z"] == -6);
}

TEST_CASE("momentum: a frictional collision conserves both", "[probe]") {
  Scene sc = scene(3, 1e-6,
                   {body(1, 0.005, 1e-3, {{0, 0, 0}}, {{1, 0.3, 0}}, {{50, -200, 100}}),
                    body(2, 0.004, 5e-4, {{0.0088, 0.001, -0.0005}}, {{-1, 0, 0.5}})},
                   frictional_law);
  Simulation s(sc);
  const Sampled before = sample(s, "momentum");
  const Vec3 spin = s.particles().body(0).spin;
  run(s, 2000);
  const Sampled after = sample(s, "momentum");
  REQUIRE(norm(s.particles().body(0).spin - spin) > 1);  // they collided with friction
  // Each of 2000 steps rounds a few numbers of the size of the largest term, m v or m v R.
  const double largest = 1e-3 * 1.2, rounding = 2000 * 8 * 2.2e-16;
  for (std::size_t k = 0; k < 6; ++k)
    CHECK(after.row[k] == Approx(before.row[k]).epsilon(0).margin(rounding * largest * (k < 3 ? 1 : 0.01)));
}

TEST_CASE("momentum: of bodies that a scenario chooses", "[probe]") {
  const Sampled m = sample(Simulation(pair_of_bodies(3)), "momentum", {}, {1, 0});
  CHECK(m["momentum_y"] == 6);
  CHECK(m["angular_momentum_x"] == Approx(-10 + 4));
}
