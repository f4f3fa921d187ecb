#include "sphere_values.hpp"

#include <numbers>

#include <catch2/catch.hpp>

// The tangential spring of `sphere_path_independent` on paths whose outcome is known.

using namespace scree;
using namespace scree::test;
using std::numbers::pi;

namespace {

SpherePose apart(double distance, const Vec3& direction) {
  return {.a = (distance / norm(direction)) * direction};
}

}  // namespace

TEST_CASE("the three residuals of tangential springs are 0 for spheres", "[sphere]") {
  for (const bool hertz : {false, true}) {
    const Values values = sphere_values(hertz, infinite_friction);
    // The mean overlap is 0.02 m, the ellipse has the semi-axes 0.005 and 0.003 m.
    const auto on_ellipse = [](double s) {
      return SpherePose{.a = {{1.98 + 0.005 * std::cos(2 * pi * s), 0.003 * std::sin(2 * pi * s), 0}}};
    };
    SpherePair ellipse = sphere_pair(values, 1, 1, on_ellipse(0));
    ellipse.follow([&](double s) { return on_ellipse(0.25 * s); }, 10);
    CHECK(norm(ellipse.spring()) == Approx(2 * std::atan(0.003 / 1.98)).epsilon(1e-12));
    ellipse.follow([&](double s) { return on_ellipse(0.25 + 0.75 * s); }, 30);
    CHECK(norm(ellipse.spring()) < pose_round_off);

    const SpherePose start = apart(1.98, {{1, 0, 0}});
    SpherePair rigid = sphere_pair(values, 1, 1, start);
    rigid.follow([&](double s) { return start.rotated({{0, 0.06 * s, 0.08 * s}}); }, 10);
    CHECK(norm(rigid.spring()) < pose_round_off);
  }
}

TEST_CASE("a closed path of centres and rotations in 3D stores no energy in the spring of spheres",
          "[sphere]") {
  // Both centres and both rotations move on loops of their own, three times round, by up to 0.03 m and 0.03
  // rad.
  for (const bool hertz : {false, true})
    for (const double radius_b : {0.8, 0.0}) {
      INFO((hertz ? "hertz" : "linear") << ", R_b = " << radius_b);
      const auto pose = [&](double s) {
        const auto loop = [&](double size, double phase) {
          const double t = 6 * pi * s + phase;
          const Vec3 at = {{std::sin(t), std::cos(2 * t), std::sin(3 * t)}},
                     from = {{std::sin(phase), std::cos(2 * phase), std::sin(3 * phase)}};
          return size * (at - from);
        };
        SpherePose p = {.a = Vec3{{0, 0, radius_b > 0 ? 1.9 : 1.1}} + loop(0.01, 0.3), .b = loop(0.003, 1)};
        p.quaternion_a = quaternion_of(loop(0.01, 2));
        if (radius_b > 0) p.quaternion_b = quaternion_of(loop(0.01, 0.5));
        return p;
      };
      SpherePair pair = sphere_pair(sphere_values(hertz, infinite_friction), 1.2, radius_b, pose(0));
      const Vec3 painted_a = pair.painted_a(), painted_b = pair.painted_b();
      pair.follow([&](double s) { return pose(0.2 * s); }, 20);
      CHECK(norm(pair.spring()) > 0.006);
      // Points of contacts that stick keep their bits: nothing adds up over many steps.
      CHECK(pair.painted_a() == painted_a);
      CHECK(pair.painted_b() == painted_b);
      pair.follow([&](double s) { return pose(0.2 + 0.8 * s); }, 80);
      CHECK(norm(pair.spring()) < pose_round_off);
      CHECK(pair.law().output(SCREE_ELASTIC_TANGENTIAL) < 1000 * pose_round_off * pose_round_off);
    }
}

TEST_CASE(
    "twist about the normal after rolling stretches the spring of spheres by the angle times the distance",
    "[sphere]") {
  constexpr double rolling = 0.09, twist = 0.05;
  SpherePose pose = {.a = {{0, 0, 0.95}}};
  SpherePair pair = sphere_pair(sphere_values(false, infinite_friction), 1, 0, pose);
  pose.a[0] = rolling;
  pose.quaternion_a = quaternion_of({{0, rolling, 0}});
  pair.follow([&](double) { return pose; }, 1);
  CHECK(norm(pair.spring()) < pose_round_off);
  pose.quaternion_a = after(quaternion_of({{0, 0, twist}}), pose.quaternion_a);
  pair.follow([&](double) { return pose; }, 1);
  CHECK(norm(pair.spring()) == Approx(2 * rolling * std::sin(0.5 * twist)).epsilon(1e-12));
}

TEST_CASE("slip moves both painted points of spheres by half and leaves the spring at the limit",
          "[sphere]") {
  constexpr double friction = 0.2, longest = friction * 100 * 0.1 / 80;  // μ k δ/k_t
  const auto spun = [](double angle) {
    SpherePose p = apart(1.9, {{1, 0, 0}});
    p.quaternion_a = quaternion_of({{0, 0, angle}});
    return p;
  };
  SpherePair pair = sphere_pair(sphere_values(false, friction), 1.2, 0.8, spun(0));
  const Vec3 first_a = pair.painted_a(), first_b = pair.painted_b();
  pair.follow([&](double s) { return spun(0.02 * s); }, 2);
  CHECK(pair.spring()[1] == Approx(-1.2 * 0.02).epsilon(1e-13));
  CHECK(pair.painted_a() == first_a);
  CHECK(pair.painted_b() == first_b);
  pair.follow([&](double s) { return spun(0.02 + 0.08 * s); }, 10);
  CHECK(pair.law().history("sliding") == 1);
  CHECK(pair.spring()[1] == Approx(-longest).epsilon(1e-13));
  // The slip, 1.2 · 0.1 − μ k δ/k_t, is shared by halves: arcs on both spheres.
  const double slip = 1.2 * 0.1 - longest;
  CHECK(norm(pair.painted_a() - first_a) == Approx(2 * std::sin(0.25 * slip / 1.2)).epsilon(1e-12));
  CHECK(norm(pair.painted_b() - first_b) == Approx(2 * std::sin(0.25 * slip / 0.8)).epsilon(1e-12));
  // Backwards the spring shortens at once, from the length that it has.
  pair.follow([&](double s) { return spun(0.1 - 0.01 * s); }, 1);
  CHECK(pair.law().history("sliding") == 0);
  CHECK(pair.spring()[1] == Approx(-longest + 1.2 * 0.01).epsilon(1e-12));
  CHECK(norm(pair.force() - Vec3{{10, 80 * (longest - 0.012) * 2 / 1.9, 0}}) < 1e-12);
}

TEST_CASE("friction between spheres has a dynamic value while they slide", "[sphere]") {
  Values values = sphere_values(false, 0.3);
  values.push_back({"dynamic_friction", {0.2}});
  const auto spun = [](double angle) {
    SpherePose p = apart(1.9, {{1, 0, 0}});
    p.quaternion_a = quaternion_of({{0, 0, angle}});
    return p;
  };
  SpherePair pair = sphere_pair(values, 1, 1, spun(0));
  // k_t/(k δ) = 8/m: static friction holds to 0.0375 m, dynamic friction leaves 0.025 m.
  pair.follow([&](double s) { return spun(0.037 * s); }, 1);
  CHECK(pair.law().history("sliding") <= 0);
  pair.follow([&](double s) { return spun(0.037 + 0.001 * s); }, 1);
  CHECK(pair.law().history("sliding") > 0);
  CHECK(norm(pair.spring()) == Approx(0.025).epsilon(1e-12));
  // It goes on sliding at the dynamic limit, below the static one.
  pair.follow([&](double s) { return spun(0.038 + 0.001 * s); }, 1);
  CHECK(pair.law().history("sliding") > 0);
  CHECK(norm(pair.spring()) == Approx(0.025).epsilon(1e-12));
}

TEST_CASE("at first touch the spring of spheres is as long as the pair moved while touching", "[sphere]") {
  for (const bool hertz : {false, true}) {
    LawBatch pair("sphere_path_independent", sphere_values(hertz, infinite_friction));
    pair.set(SCREE_NORMAL, {{0, 0, 1}});
    // The displacement is perpendicular to the mid-step normal, the spring to the present one.
    pair.set(SCREE_TANGENTIAL_INCREMENT, {{0.003, -0.004, 0.0001}});
    pair.set(SCREE_SEPARATION, {{0, 0, 1.9}});
    pair.input(SCREE_OVERLAP) = 0.1;
    pair.input(SCREE_RADII, 0) = 1.2;
    pair.input(SCREE_RADII, 1) = 0.8;
    pair.input(SCREE_ORIENTATION_A) = pair.input(SCREE_ORIENTATION_B) = 1;
    pair.evaluate(1);
    CHECK(pair.history("spring_x") == Approx(0.003).epsilon(1e-14));
    CHECK(pair.history("spring_y") == Approx(-0.004).epsilon(1e-14));
    CHECK(pair.history("spring_z") == 0);
    const double stiffness = pair.output(SCREE_ELASTIC_TANGENTIAL) / (0.5 * 0.005 * 0.005);
    CHECK(pair.output(SCREE_FORCE, 0) == Approx(-stiffness * 0.003 * 2 / 1.9).epsilon(1e-4));
    // With no further displacement the painted points have the same spring.
    pair.set(SCREE_TANGENTIAL_INCREMENT, {});
    pair.evaluate(1);
    CHECK(pair.history("spring_x") == Approx(0.003).epsilon(1e-12));
    CHECK(pair.history("spring_y") == Approx(-0.004).epsilon(1e-12));
  }
}
