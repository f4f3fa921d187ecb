#include "wall_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

namespace {

void make_periodic(Scene& sc, double axes, double length) {
  add_boundary(sc, "periodic", {{"axes", {axes}}, {"lower", {0, 0, 0}}, {"upper", {length, length, length}}});
}

}  // namespace

TEST_CASE("a body that crosses a periodic face re-enters at the opposite one", "[periodic]") {
  Scene sc = scene(3, 1e-3, {body(1, 0.1, 1, {{0.9, 0.5, 0.5}}, {{1, 1, -1}})}, elastic);
  make_periodic(sc, 3, 1);  // x and y
  Simulation s(sc);
  run(s, 3350);
  // Positions are folded in neighbour searches, at most one skin after the crossing.
  const Vec3 x = position(s, 0);
  CHECK(x[0] == Approx(0.25).margin(0.01));
  CHECK(x[1] == Approx(0.85).margin(0.01));
  CHECK(x[2] == Approx(0.5 - 3.35));
  CHECK(s.particles().image[0][0] == 4);
  CHECK(s.particles().image[1][0] == 3);
}

TEST_CASE("bodies collide through a periodic face as they do inside", "[periodic]") {
  const auto outcome = [](double shift) {
    const auto fold = [](double x) { return x - std::floor(x); };
    Scene sc = scene(3, 1e-5,
                     {body(1, 0.1, 1, {{fold(0.35 + shift), 0.5, 0.5}}, {{1, 0.1, 0}}),
                      body(2, 0.1, 1, {{fold(0.65 + shift), 0.52, 0.5}}, {{-1, 0, 0}})},
                     elastic);
    make_periodic(sc, 6, 1);
    Simulation s(sc);
    run(s, 20000);
    return std::pair{velocity(s, 0), velocity(s, 1)};
  };
  const auto inside = outcome(0);
  REQUIRE(inside.first[0] < 0);  // they have collided
  for (const double shift : {0.4, 0.5, 0.6}) {
    const auto through = outcome(shift);
    // Coordinates of order 1 are rounded differently: 1e-16 in the overlap, over k Δt / m = 0.1 /s per step
    // and 4400 steps of contact.
    CHECK(norm(through.first - inside.first) < 1e-11);
    CHECK(norm(through.second - inside.second) < 1e-11);
  }
}

TEST_CASE("a periodic axis must have a length, exist in the scene, and be given once", "[periodic]") {
  Scene flat = scene(2, 1e-3, {body(1, 0.1, 1, {{0.5, 0.5, 0}}, {}, {}, 2)}, elastic);
  make_periodic(flat, 2, 1);
  CHECK_THROWS_WITH(Simulation(flat), Catch::Contains("no z axis"));
  Scene empty = scene(3, 1e-3, {body(1, 0.1, 1, {{0.5, 0.5, 0.5}})}, elastic);
  make_periodic(empty, 0, -1);
  CHECK_THROWS_WITH(Simulation(empty), Catch::Contains("upper is not above lower"));
  Scene twice = scene(3, 1e-3, {body(1, 0.1, 1, {{0.5, 0.5, 0.5}})}, elastic);
  make_periodic(twice, 0, 1);
  make_periodic(twice, 3, 1);
  CHECK_THROWS_WITH(Simulation(twice), Catch::Contains("already periodic"));
}

TEST_CASE("a wall must not be normal to a periodic axis", "[periodic]") {
  const auto with_plane = [](const std::vector<double>& normal) {
    Scene sc = scene(3, 1e-3, {body(1, 0.1, 1, {{0.5, 0.5, 0.5}})}, elastic);
    make_periodic(sc, 0, 1);
    add_boundary(sc, "plane", {{"point", {0, 0, 0}}, {"normal", normal}}, "floor");
    return sc;
  };
  CHECK_NOTHROW(Simulation(with_plane({0, 1, 1})));
  CHECK_THROWS_WITH(Simulation(with_plane({0.1, 1, 0})), Catch::Contains("wall floor is normal to x"));
}
