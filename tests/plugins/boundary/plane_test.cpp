#include "wall_support.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;
using std::numbers::pi;

namespace {

Simulation moving_plane(const std::vector<double>& displacement, double step) {
  Scene sc = scene(3, step, {body(1, 0.01, 0.01, {{0, 0, 1}})}, elastic);
  add_boundary(sc, "plane", {{"point", {0, 0, 0.2}}, {"normal", {0, 0, 2}}, {"displacement", displacement}});
  return Simulation(sc);
}

}  // namespace

TEST_CASE("a plane follows its program: sine, cycle, ramp, table", "[plane]") {
  const double step = 1e-3;
  // A sum of 300 differences of the program: round-off only.
  const double round_off = 300 * 1e-16;
  SECTION("sine") {
    Simulation s = moving_plane({1, 0, 0.01, 2, 0}, step);
    run(s, 300);
    CHECK(height_of_wall(s) == Approx(0.2 + 0.01 * std::sin(2 * pi * 2 * 0.3)).margin(round_off));
    CHECK(s.planes()[0].velocity[2] == Approx(0.01 * 4 * pi * std::cos(2 * pi * 2 * 0.3)));
  }
  SECTION("cycle") {
    Simulation s = moving_plane({2, 0, 0.02, 0.5}, step);
    run(s, 250);
    CHECK(height_of_wall(s) == Approx(0.22).margin(round_off));
  }
  SECTION("ramp") {
    Simulation s = moving_plane({3, 0, -0.05, 0.1}, step);
    run(s, 50);
    CHECK(height_of_wall(s) == Approx(0.175).margin(round_off));
    run(s, 250);
    CHECK(height_of_wall(s) == Approx(0.15).margin(round_off));
    CHECK(s.planes()[0].velocity[2] == 0);
  }
  SECTION("table") {
    Simulation s = moving_plane({4, 0, 0, 0.1, 0.01, 0.2, 0.01, 0.3, -0.01}, step);
    run(s, 150);
    CHECK(height_of_wall(s) == Approx(0.21).margin(round_off));
    run(s, 150);
    CHECK(height_of_wall(s) == Approx(0.19).margin(round_off));
  }
}

TEST_CASE("a fixed plane reflects a body elastically, at any angle", "[plane]") {
  for (const double angle : {0.0, 30.0, 60.0, 85.0}) {
    const double a = angle * pi / 180, speed = 1;
    Scene sc = scene(
        3, 1e-6, {body(1, 0.01, 0.01, {{0, 0, 0.0101}}, {{speed * std::sin(a), 0, -speed * std::cos(a)}})},
        elastic);
    add_boundary(sc, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
    Simulation s(sc);
    const double contact = pi * std::sqrt(0.01 / 1e4);
    run(s, std::uint64_t((contact + 2.5e-4 / std::cos(a)) / 1e-6));
    INFO(angle << " degrees");
    // Step error of the corners in the force at first and last touch, (ωΔt)²/8 each, ωΔt = 1e-3.
    CHECK(velocity(s, 0)[2] == Approx(speed * std::cos(a)).epsilon(2.5e-7));
    CHECK(velocity(s, 0)[0] == Approx(speed * std::sin(a)).epsilon(1e-14));
  }
}

TEST_CASE("a moving plane adds twice its velocity to a body, and the work is in the balance", "[plane]") {
  const double speed = 0.5;
  Scene sc = scene(3, 1e-6, {body(1, 0.01, 0.01, {{0, 0, 0.0101}})}, elastic);
  add_boundary(sc, "plane",
               {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"displacement", {3, 0, 1, 1 / speed}}});
  Simulation s(sc);
  run(s, 5000);
  CHECK(velocity(s, 0)[2] == Approx(2 * speed).epsilon(1e-6));
  const scree_energy e = s.energy();
  CHECK(e.work == Approx(0.5 * 0.01 * 4 * speed * speed).epsilon(1e-6));
  CHECK(std::abs(e.residual) < 1e-6 * e.work);
}

TEST_CASE("a plane that stops and restarts uses its present load each time it starts", "[plane]") {
  const double step = 1e-6, speed = 1, frequency = 1e3;
  const Values still = {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}};
  Values moving = still;
  moving.push_back({"displacement", {3, 0, 1, 1 / speed}});
  Scene sc = scene(3, step, {body(1, 0.01, 0.01, {{0, 0, 0.01}}, {{0, 0, -1}})}, elastic);
  add_boundary(sc, "plane", still, "ground");
  Simulation s(sc);
  const auto change = [&](const Values& values) {
    s.reconfigure_boundary("ground", parameters("plane", SCREE_BOUNDARY, values));
  };
  const auto plane_velocity = [&] { return s.planes()[0].velocity[2]; };
  for (int start = 0; start < 2; ++start) {
    run(s, 700);
    CHECK(plane_velocity() == 0);
    change(moving);
    run(s, 300);
    CHECK(plane_velocity() == speed);
    change(still);
  }
  CHECK(plane_velocity() == 0);
  CHECK(height_of_wall(s) == Approx(600 * step * speed));
  // Step error of the energy balance, (ωΔt)². A stale load from before a rest would cause an error of
  // F v Δt/2, a thousandth of the energy.
  const scree_energy e = s.energy();
  REQUIRE(e.work > 0);
  CHECK(std::abs(e.residual) < frequency * frequency * step * step * e.work);
}

TEST_CASE("a plane can move in its own direction and must have a nonzero normal", "[plane]") {
  Scene sc = scene(3, 1e-3, {body(1, 0.01, 0.01, {{0, 0, 1}})}, elastic);
  add_boundary(sc, "plane",
               {{"point", {0, 0, 0}},
                {"normal", {0, 0, 1}},
                {"direction", {3, 0, 0}},
                {"displacement", {3, 0, 0.1, 1}}});
  Simulation s(sc);
  run(s, 100);
  CHECK(s.planes()[0].point[0] == Approx(0.01));
  CHECK(s.planes()[0].point[2] == 0);

  Scene bad = scene(3, 1e-3, {}, elastic);
  add_boundary(bad, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 0}}});
  CHECK_THROWS_WITH(Simulation(bad), Catch::Contains("normal has length 0"));

  Scene still = scene(3, 1e-3, {}, elastic);
  add_boundary(still, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"direction", {0, 0, 0}}});
  CHECK_THROWS_WITH(Simulation(still), Catch::Contains("direction has length 0"));
}

TEST_CASE("a normal may have any length", "[plane]") {
  for (const double length : {1e-320, 1e-200, 1.0, 1e160, 1e308}) {
    Scene sc = scene(3, 1e-3, {body(1, 0.01, 0.01, {{0, 0, 1}})}, elastic);
    add_boundary(sc, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0.6 * length, 0.8 * length}}});
    Simulation s(sc);
    // Numbers near the smallest have few digits: 1e-320 is 2024 of its units.
    const double digits = length < 1e-300 ? 1e-3 : 1e-15;
    CHECK(s.planes()[0].normal[1] == Approx(0.6).margin(digits));
    CHECK(s.planes()[0].normal[2] == Approx(0.8).margin(digits));
  }
}

TEST_CASE("a plane with a displacement and another motion has a control", "[plane]") {
  const auto plane = [](const Values& more) {
    Scene sc = scene(3, 1e-3, {body(1, 0.01, 0.01, {{0, 0, 1}})}, elastic);
    Values all = {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"displacement", {3, 0, 0.1, 1}}};
    all.insert(all.end(), more.begin(), more.end());
    add_boundary(sc, "plane", all);
    return sc;
  };
  for (const char* other : {"velocity", "stress", "force", "superposed"})
    CHECK_THROWS_WITH(Simulation(plane({{other, {0.5}}})),
                      Catch::Contains("displacement and another motion are given without control; give "));
  // The other one may wait for its stage.
  Simulation s(plane({{"velocity", {0.5}}, {"control", {1}}}));
  run(s, 100);
  CHECK(s.planes()[0].point[2] == Approx(0.01));
}
