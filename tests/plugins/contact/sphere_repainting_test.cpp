#include "sphere_values.hpp"

#include <algorithm>
#include <numbers>

#include <catch2/catch.hpp>

// Spheres that roll so far that `sphere_path_independent` paints their points anew.

using namespace scree;
using namespace scree::test;
using std::numbers::pi;

namespace {

constexpr double arc_limit = 0.1;  // (rad)

// a rolls on b, which is held, along a great circle of b from the direction x to y by an angle (rad).
SpherePose rolled(double radius_a, double radius_b, double distance, double angle) {
  SpherePose p = {.a = {{distance * std::cos(angle), distance * std::sin(angle), 0}}};
  p.quaternion_a = quaternion_of({{0, 0, (radius_a + radius_b) / radius_a * angle}});
  return p;
}

// Before it rolls a turns about y, so that the spring across the direction of rolling is `across` (m) long.
SpherePose rolled_across(double radius_a, double radius_b, double distance, double angle, double across) {
  SpherePose p = rolled(radius_a, radius_b, distance, angle);
  p.quaternion_a = after(p.quaternion_a, quaternion_of({{0, across / radius_a, 0}}));
  return p;
}

SpherePair rolling_pair(double radius_a, double radius_b, double distance) {
  return sphere_pair(sphere_values(false, infinite_friction), radius_a, radius_b,
                     rolled(radius_a, radius_b, distance, 0));
}

// What a loop of this radius (m) on a wall leaves in the spring of a sphere of radius 1.
template <class Orientation>
double left_by_loop(double loop, const Orientation& orientation) {
  const auto pose = [&](double s) {
    const Vec3 x = {{loop * (std::cos(2 * pi * s) - 1), loop * std::sin(2 * pi * s), 0.95}};
    return SpherePose{.a = x, .quaternion_a = orientation(x, s)};
  };
  SpherePair pair = sphere_pair(sphere_values(false, infinite_friction), 1, 0, pose(0));
  pair.follow(pose, 4000);
  return norm(pair.spring());
}

}  // namespace

TEST_CASE("spheres of unequal radii that roll on each other keep their spring at 0", "[sphere]") {
  // Once around b: the points are painted anew every 0.1 rad, each time within the round-off of ξ.
  constexpr double radius_a = 0.7, radius_b = 0.9, distance = 1.59;
  SpherePair pair = rolling_pair(radius_a, radius_b, distance);
  const auto pose = [&](double s) { return rolled(radius_a, radius_b, distance, 2 * pi * s); };
  pair.follow([&](double s) { return pose(0.01 * s); }, 10);
  CHECK(norm(pair.spring()) < pose_round_off);
  pair.follow([&](double s) { return pose(0.01 + 0.99 * s); }, 600);
  const double repaints = 2 * pi * radius_b / (radius_a * arc_limit);
  CHECK(norm(pair.spring()) < repaints * pose_round_off);

  // On a wall, ten radii far.
  const auto on_wall = [](double s) {
    return SpherePose{.a = {{6 * s, 8 * s, 0.95}}, .quaternion_a = quaternion_of({{-8 * s, 6 * s, 0}})};
  };
  SpherePair wall = sphere_pair(sphere_values(true, infinite_friction), 1, 0, on_wall(0));
  wall.follow(on_wall, 600);
  CHECK(norm(wall.spring()) < 10 / arc_limit * 10 * pose_round_off);
}

TEST_CASE("a spring across the direction in which spheres roll does not grow", "[sphere]") {
  // Between two paintings it grows by the mean of φ/sin φ of both arcs, up to 0.1 rad and one step. Kept,
  // that is exp(φ/6) per rad of two equal spheres. The painting shortens it by more, up to 0.022 φ⁴ each
  // time.
  constexpr double across = 1e-4, step = 5e-3, rolling = 60;
  for (const double radius_b : {1.0, 0.4}) {
    INFO("R_b = " << radius_b);
    const auto pose = [&](double s) {
      return rolled_across(1, radius_b, 0.95 + radius_b, rolling / radius_b * s, across);
    };
    SpherePair pair = rolling_pair(1, radius_b, 0.95 + radius_b);
    pair.follow([&](double) { return pose(0); }, 1);
    REQUIRE(norm(pair.spring()) == Approx(across).epsilon(1e-12));
    double largest = 0, dissipated = 0;
    for (int k = 0; k < int(rolling / step); ++k) {
      pair.follow([&](double s) { return pose((k + s) * step / rolling); }, 1);
      largest = std::max(largest, norm(pair.spring()));
      dissipated += pair.law().output(SCREE_DISSIPATED_FRICTION);
    }
    const double arc = arc_limit + step / std::min(radius_b, 1.0);
    CHECK(largest < across * (1 + arc * arc / 6));
    CHECK(norm(pair.spring()) > across * (1 - 0.022 * arc * arc * arc * rolling / std::min(radius_b, 1.0)));
    CHECK(dissipated > 0);
  }
}

TEST_CASE("closed paths on which a painted point goes farther than 0.1 rad leave a spring of spheres",
          "[sphere]") {
  // With the rotation vector z × x/R that belongs to the displacement x: free where the diameter is below
  // 0.1. Pure rolling along the same loop turns the sphere by the solid angle π ρ² about the normal; larger
  // loops leave half of that times ρ.
  const auto by_vector = [](const Vec3& x, double) { return quaternion_of({{-x[1], x[0], 0}}); };
  CHECK(left_by_loop(0.045, by_vector) < pose_round_off);
  CHECK(left_by_loop(0.1, by_vector) == Approx(0.0015).epsilon(0.01));
  CHECK(left_by_loop(0.3, by_vector) == Approx(0.0422).epsilon(0.01));
  // The same loop with rolling, and twist at an equal rate that ends in the first orientation.
  const auto evenly = [](double loop) {
    return [loop](const Vec3&, double s) {
      const double turn = 2 * pi * s;
      return after(quaternion_of({{0, 0, turn}}),
                   quaternion_of({{-loop * turn, 0, -std::sqrt(1 - loop * loop) * turn}}));
    };
  };
  CHECK(left_by_loop(0.045, evenly(0.045)) < pose_round_off);
  CHECK(left_by_loop(0.3, evenly(0.3)) < 3e-4);
}
