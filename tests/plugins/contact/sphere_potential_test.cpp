#include "sphere_values.hpp"

#include <algorithm>
#include <random>

#include <catch2/catch.hpp>

// Forces and torques of `sphere_path_independent` without slip: those of a potential, for any configuration.

using namespace scree;
using namespace scree::test;

namespace {

// Ten roundings of positions of 2 m, 4e-16 m each, times 100 N/m; of torques with arms of 1 m.
constexpr double potential_round_off = 4e-13;

struct Configuration {
  double radius_a, radius_b;         // (m); of a wall 0
  SpherePose start = {}, pose = {};  // at first touch and now
};

Vec3 random_vector(std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> component(-size, size);
  return {{component(random), component(random), component(random)}};
}

// Orientations of any size at first touch; since then the bodies moved by about 0.02 radii and turned by as
// many rad: all arcs are below 0.1 rad.
Configuration random_configuration(std::mt19937_64& random, bool wall) {
  std::uniform_real_distribution<double> radius(0.6, 1.4);
  Configuration c{.radius_a = radius(random), .radius_b = wall ? 0 : radius(random)};
  const Vec3 b = random_vector(random, 1), direction = random_vector(random, 1);
  const Vec3 normal = wall ? Vec3{{0, 0, 1}} : (1 / norm(direction)) * direction;
  c.start = {.a = b + (c.radius_a + c.radius_b - 0.1) * normal,
             .b = b,
             .quaternion_a = quaternion_of(random_vector(random, 2)),
             .quaternion_b = wall ? quaternion_of({}) : quaternion_of(random_vector(random, 2))};
  c.pose = c.start;
  c.pose.a += random_vector(random, 0.02);
  c.pose.quaternion_a = after(quaternion_of(random_vector(random, 0.03)), c.start.quaternion_a);
  if (!wall) c.pose.quaternion_b = after(quaternion_of(random_vector(random, 0.03)), c.start.quaternion_b);
  return c;
}

SpherePair pair_at(const Configuration& c, bool hertz, const SpherePose& pose) {
  SpherePair pair = sphere_pair(sphere_values(hertz, infinite_friction), c.radius_a, c.radius_b, c.start);
  pair.follow([&](double) { return pose; }, 1);
  return pair;
}

// Derivative of the energy along change(pose, amount), by differences of fourth order.
template <class Change>
double slope(const Configuration& c, bool hertz, const Change& change) {
  constexpr double h = 2e-4;
  const auto energy = [&](double amount) {
    SpherePose pose = c.pose;
    change(pose, amount);
    return pair_at(c, hertz, pose).energy();
  };
  return (8 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12 * h);
}

template <class Visit>
void each_configuration(int count, const Visit& visit) {
  std::mt19937_64 random(11);
  for (const bool hertz : {false, true})
    for (const bool wall : {false, true})
      for (int k = 0; k < count; ++k) {
        INFO((hertz ? "hertz" : "linear") << (wall ? ", wall, " : ", pair, ") << k);
        visit(random_configuration(random, wall), hertz);
      }
}

}  // namespace

TEST_CASE("forces and torques on spheres are the gradient of the energy", "[sphere]") {
  // Truncation h⁴ f⁽⁵⁾/30, with f⁽⁵⁾ of 200 J (δ/m)^(5/2) at δ >= 0.02 m below 200 · 3.3 · 0.02^(−5/2) =
  // 1.2e7 J/m⁵: 6e-10 N; round-off 1e-16 · 1 J/h = 1e-12 N.
  each_configuration(50, [](const Configuration& c, bool hertz) {
    const SpherePair pair = pair_at(c, hertz, c.pose);
    constexpr double bound = 1e-8;
    REQUIRE(norm(pair.spring()) > 1e-3);
    for (int k = 0; k < 3; ++k) {
      Vec3 axis = {};
      axis[k] = 1;
      CHECK(std::abs(pair.force()[k] +
                     slope(c, hertz, [&](SpherePose& p, double amount) { p.a += amount * axis; })) < bound);
      CHECK(std::abs(pair.torque_on_a()[k] + slope(c, hertz, [&](SpherePose& p, double amount) {
                       p.quaternion_a = after(quaternion_of(amount * axis), p.quaternion_a);
                     })) < 1e-8);
      if (c.radius_b > 0)
        CHECK(std::abs(pair.torque_on_b()[k] + slope(c, hertz, [&](SpherePose& p, double amount) {
                         p.quaternion_b = after(quaternion_of(amount * axis), p.quaternion_b);
                       })) < 1e-8);
    }
  });
}

TEST_CASE("the laws for spheres conserve angular momentum", "[sphere]") {
  each_configuration(50, [](const Configuration& c, bool hertz) {
    if (c.radius_b == 0) return;
    const SpherePair pair = pair_at(c, hertz, c.pose);
    const Vec3 orbital = cross(c.pose.a - c.pose.b, pair.force());
    REQUIRE(norm(orbital) > 0.01);
    CHECK(norm(pair.torque_on_a() + pair.torque_on_b() + orbital) < potential_round_off);
  });
}

TEST_CASE("a rotation of the whole pair rotates forces and torques on spheres", "[sphere]") {
  each_configuration(10, [](const Configuration& c, bool hertz) {
    // A wall has its normal along z.
    const Vec3 rotation = c.radius_b > 0 ? Vec3{{0.5, -1.3, 0.8}} : Vec3{{0, 0, 1.1}};
    Configuration other = c;
    other.start = c.start.rotated(rotation), other.pose = c.pose.rotated(rotation);
    if (c.radius_b == 0) other.start.quaternion_b = other.pose.quaternion_b = quaternion_of({});
    const SpherePair here = pair_at(c, hertz, c.pose), there = pair_at(other, hertz, other.pose);
    CHECK(norm(there.force() - turned(rotation, here.force())) < potential_round_off);
    CHECK(norm(there.torque_on_a() - turned(rotation, here.torque_on_a())) < potential_round_off);
    if (c.radius_b > 0)
      CHECK(norm(there.torque_on_b() - turned(rotation, here.torque_on_b())) < potential_round_off);
  });
}

TEST_CASE("spheres that change their names exchange forces and torques", "[sphere]") {
  each_configuration(10, [](const Configuration& c, bool hertz) {
    if (c.radius_b == 0) return;
    const auto exchanged = [](const SpherePose& p) {
      return SpherePose{.a = p.b, .b = p.a, .quaternion_a = p.quaternion_b, .quaternion_b = p.quaternion_a};
    };
    const Configuration other = {c.radius_b, c.radius_a, exchanged(c.start), exchanged(c.pose)};
    const SpherePair here = pair_at(c, hertz, c.pose), there = pair_at(other, hertz, other.pose);
    CHECK(norm(there.force() + here.force()) < potential_round_off);
    CHECK(norm(there.torque_on_a() - here.torque_on_b()) < potential_round_off);
    CHECK(norm(there.torque_on_b() - here.torque_on_a()) < potential_round_off);
  });
}

TEST_CASE("a wall is the limit of a large sphere", "[sphere]") {
  constexpr double large = 1e6;
  each_configuration(10, [](const Configuration& c, bool hertz) {
    if (c.radius_b > 0) return;
    Configuration other = c;
    other.radius_b = large;
    other.start.b[2] -= large, other.pose.b[2] -= large;
    // The wall is the plane through b, whatever b's other coordinates; the sphere's summit is above its
    // centre.
    for (int k = 0; k < 2; ++k) other.start.b[k] = other.pose.b[k] = c.start.a[k];
    const SpherePair wall = pair_at(c, hertz, c.pose), sphere = pair_at(other, hertz, other.pose);
    // Slopes of 0.05 m/1e6 m times the normal force, positions of 1e6 m that are rounded to 1e-10 m.
    CHECK(norm(sphere.spring() - wall.spring()) < 1e-6);
    CHECK(norm(sphere.force() - wall.force()) < 1e-5 * norm(wall.force()));
    CHECK(norm(sphere.torque_on_a() - wall.torque_on_a()) < 1e-5 * norm(wall.force()));
  });
}
