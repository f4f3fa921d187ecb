#include "disc_pair.hpp"
#include "sphere_pair.hpp"

#include <cstdio>
#include <numbers>

#include <catch2/catch.hpp>

// What the tangential spring of every family of laws keeps after two motions that a path-independent spring
// forgets: two bodies of radius 1 with a mean overlap of 0.02, moved without rotation once round a circle of
// radius 0.005, and rotated by 0.1 rad as one rigid body.

using namespace scree;
using namespace scree::test;
using std::numbers::pi;

namespace {

constexpr int steps = 1000;

struct Family {
  std::string law;
  Values values;
  double circle, rotation;  // expected springs (m)
  double tolerance;         // (m)
};

std::vector<Family> families() {
  const double enclosed = pi * 0.005 * 0.005 / 1.98;  // area over the distance
  // Chords in place of arcs: (2π/1000)²/6 of the area, 1e-5, and (0.1/1000)²/24 of the arc.
  const double chords = 1e-4 * enclosed, round_off = 4 * 4e-16 * 2;
  const Values springs = {
      {"normal_stiffness", {100}}, {"normal_damping", {0}}, {"tangential_stiffness", {80}}};
  const auto with = [](Values values, const std::string& key, double value) {
    values.push_back({key, {value}});
    return values;
  };
  const Values disc = with(springs, "friction", 1e9), sphere = with(springs, "static_friction", 1e9);
  const Values hertz = {{"youngs_modulus", {300}}, {"poissons_ratio", {0.3}}, {"friction", {1e9}}};
  return {{"linear_spring_dashpot", sphere, enclosed, 0, chords},
          {"hertz_mindlin", with(hertz, "history", 2), enclosed, 0, chords},
          {"disc_cundall_strack", disc, enclosed, -2e-3, chords},
          {"disc_corrected", disc, 0, 0, chords},
          {"disc_angular", disc, 0, 0, round_off},
          {"sphere_path_independent", sphere, 0, 0, round_off},
          {"sphere_path_independent", with(hertz, "normal", 1), 0, 0, round_off}};
}

// Length of the spring along y after a path of a about b; in 2D with the sign of the law.
struct Discs {
  DiscPose circle(double s) const { return {.a = {{1.98 + 0.005 * std::cos(s), 0.005 * std::sin(s)}}}; }
  DiscPose rotation(double angle) const {
    return {.a = {{1.98 * std::cos(angle), 1.98 * std::sin(angle)}}, .angle_a = angle, .angle_b = angle};
  }
  template <class Pose>
  static double spring_after(const Family& family, const Pose& pose) {
    DiscPair pair(family.law, family.values, 1, 1, pose(0));
    pair.follow(pose, steps);
    return pair.law().has_history("spring") ? pair.spring() : pair.law().history("spring_y");
  }
};
struct Spheres {
  SpherePose circle(double s) const { return {.a = {{1.98 + 0.005 * std::cos(s), 0.005 * std::sin(s), 0}}}; }
  SpherePose rotation(double angle) const { return SpherePose{.a = {{1.98, 0, 0}}}.rotated({{0, 0, angle}}); }
  template <class Pose>
  static double spring_after(const Family& family, const Pose& pose) {
    SpherePair pair(family.law, family.values, 1, 1, pose(0));
    pair.follow(pose, steps);
    return pair.spring()[1];
  }
};

template <class Bodies>
void check(const Family& family, const Bodies& bodies, const char* dimension) {
  const double circle = bodies.spring_after(family, [&](double s) { return bodies.circle(2 * pi * s); });
  const double rotation = bodies.spring_after(family, [&](double s) { return bodies.rotation(0.1 * s); });
  char line[120];
  std::snprintf(line, sizeof(line), "%-24s %s  circle %9.2e  rigid rotation %9.2e m", family.law.c_str(),
                dimension, circle, rotation);
  WARN(line);
  CHECK(std::abs(circle - family.circle) < family.tolerance);
  CHECK(std::abs(rotation - family.rotation) < std::max(family.tolerance, 1e-4 * std::abs(family.rotation)));
}

}  // namespace

TEST_CASE("a circle and a rigid rotation leave what each family of tangential springs leaves",
          "[residuals]") {
  for (const Family& family : families())
    for (const int dimension : dimensions_of(parameters(family.law, SCREE_CONTACT_LAW, family.values)))
      if (dimension == 2)
        check(family, Discs{}, "2D");
      else
        check(family, Spheres{}, "3D");
}
