#include "disc_pair.hpp"

#include <algorithm>
#include <numbers>

#include <catch2/catch.hpp>

// The laws for discs of McNamara et al. 2008 on paths whose outcome is known, [M6]-[M30].

using namespace scree;
using namespace scree::test;
using std::numbers::pi;

namespace {

Values values(double friction, const std::string& normal = "overlap") {
  return {{"normal", {normal == "area" ? 1.0 : 0.0}},
          {"normal_stiffness", {100}},
          {"normal_damping", {0}},
          {"tangential_stiffness", {80}},
          {"friction", {friction}}};
}

// a at the polar angle and distance from b.
DiscPose at(double distance, double angle) {
  return {.a = {{distance * std::cos(angle), distance * std::sin(angle)}}};
}

// The path of figure 8, without rotation: in along the normal, along an arc, out, and back along another arc.
double spring_after_figure_8(const std::string& plugin, int steps) {
  constexpr double near = 1.9, far = 1.97, turn = 0.3, start = 2.9;
  DiscPair pair(plugin, values(infinite_friction), 1.2, 0.8, at(far, start));
  pair.follow([&](double s) { return at(far + (near - far) * s, start); }, steps);
  pair.follow([&](double s) { return at(near, start + turn * s); }, steps);
  pair.follow([&](double s) { return at(near + (far - near) * s, start + turn); }, steps);
  pair.follow([&](double s) { return at(far, start + turn * (1 - s)); }, steps);
  return pair.spring();
}

// Two discs of radius 1 with a mean overlap of 0.02, without rotation: to and fro on a line.
double spring_after_line(const std::string& plugin, int steps) {
  constexpr double a = 0.005;
  const auto pose = [&](double s) {
    return DiscPose{.a = {{1.98 + a * std::cos(2 * pi * s), a * std::cos(2 * pi * s)}}};
  };
  DiscPair pair(plugin, values(infinite_friction), 1, 1, pose(0));
  pair.follow(pose, steps);
  return pair.spring();
}

}  // namespace

TEST_CASE("a closed path changes the spring of Cundall and Strack by (r2 - r1) times the angle", "[disc]") {
  // [M17]: the arcs are 1.9 x 0.3 and 1.97 x 0.3. Chords are shorter than arcs by (Δθ)²/24.
  const double exact = (1.9 - 1.97) * 0.3;
  CHECK(spring_after_figure_8("disc_cundall_strack", 1000) == Approx(exact).epsilon(std::pow(0.3 / 1000, 2)));
}

TEST_CASE("a closed path changes the integrated spring in proportion to the step", "[disc]") {
  // Arcs at a constant distance leave nothing: only their chords, which are shorter by (Δθ)²/24. On the line
  // α of the end of each step is ahead of the mean by ½ α′h: the way out and the way back leave ½ h ∮ α′ y′
  // ds, with α′ = x′ 2/D² and x = y = a cos(2πs): −2 (πa/D)² h. The next order is (2πh)².
  CHECK(std::abs(spring_after_figure_8("disc_corrected", 1000)) <
        0.3 * 2 * std::pow(0.3 / 1000, 2) / 24 * 1.1);
  for (const int steps : {250, 500}) {
    const double exact = -2 * std::pow(pi * 0.005 / 1.98, 2) / steps;
    CHECK(spring_after_line("disc_corrected", steps) == Approx(exact).epsilon(0.01));
  }
  // Without α the spring returns on the line.
  CHECK(std::abs(spring_after_line("disc_cundall_strack", 250)) < 1e-15);
}

TEST_CASE("a closed path changes the spring between painted points by round-off", "[disc]") {
  // Angles of up to π are rounded to 4e-16, times the radii of 1.2 and 0.8 m.
  CHECK(std::abs(spring_after_figure_8("disc_angular", 100)) < 4 * 4e-16 * 2);
}

TEST_CASE("forces and torques between painted points are the gradient of the energy", "[disc]") {
  // Differences of second order with h = 1e-6: truncation 1e-12, round-off 1e-16 x 0.5 J/h = 1e-10.
  for (const std::string normal : {"overlap", "area"})
    for (const double radius_b : {0.8, 0.0}) {
      INFO(normal << ", R_b = " << radius_b);
      const DiscPose start = radius_b > 0 ? at(1.9, 2.0) : DiscPose{.a = {{0.3, 1.15}}};
      const auto energy = [&](const DiscPose& moved) {
        DiscPair pair("disc_angular", values(infinite_friction, normal), 1.2, radius_b, start);
        pair.follow([&](double) { return moved; }, 1);
        return pair.energy();
      };
      DiscPose pose = start;
      pose.a += Vec2{{0.02, -0.03}};
      pose.angle_a = 0.04, pose.angle_b = radius_b > 0 ? -0.01 : 0;
      DiscPair pair("disc_angular", values(infinite_friction, normal), 1.2, radius_b, start);
      pair.follow([&](double) { return pose; }, 1);
      constexpr double h = 1e-6, bound = 1e-8;
      const auto slope = [&](double DiscPose::*angle) {
        DiscPose more = pose, less = pose;
        more.*angle += h, less.*angle -= h;
        return (energy(more) - energy(less)) / (2 * h);
      };
      for (int k = 0; k < 2; ++k) {
        DiscPose more = pose, less = pose;
        more.a[k] += h, less.a[k] -= h;
        CHECK(pair.force()[k] == Approx(-(energy(more) - energy(less)) / (2 * h)).margin(bound));
      }
      CHECK(pair.torque_a() == Approx(-slope(&DiscPose::angle_a)).margin(bound));
      if (radius_b > 0) CHECK(pair.torque_b() == Approx(-slope(&DiscPose::angle_b)).margin(bound));
      CHECK(std::abs(pair.spring()) > 0.01);
    }
}

TEST_CASE(
    "the arms of the corrected laws conserve angular momentum, those of Cundall and Strack but for the overlap",
    "[disc]") {
  DiscPose pose = at(1.9, 0.7);
  pose.angle_a = 0.03, pose.angle_b = 0.02;
  for (const std::string plugin : {"disc_corrected", "disc_angular", "disc_cundall_strack"}) {
    DiscPair pair(plugin, values(infinite_friction), 1.2, 0.8, at(1.95, 0.6));
    pair.follow([&](double) { return pose; }, 1);
    const Vec2 f = pair.force();
    const double orbital = pose.a[0] * f[1] - pose.a[1] * f[0];
    const double sum = pair.torque_a() + pair.torque_b() + orbital;
    const double tangential = std::abs(orbital) / 1.9;
    INFO(plugin);
    REQUIRE(tangential > 1);
    CHECK(std::abs(sum) == Approx(plugin == "disc_cundall_strack" ? 0.1 * tangential : 0).margin(1e-13));
  }
}

TEST_CASE("the work of the corrected laws is taken from the energy of the spring", "[disc]") {
  // Along an arc of the centres α enters, in the rotation of a its full radius. Sums by the trapezoidal rule
  // over 1000 steps; α of the end of each step is constant on an arc. Without α the force would be 5 % short.
  for (const std::string plugin : {"disc_corrected", "disc_angular"})
    for (const bool turning : {false, true}) {
      INFO(plugin << ", turning " << turning);
      const auto pose = [&](double s) {
        DiscPose p = at(1.9, turning ? 0 : 0.05 * s);
        p.angle_a = turning ? 0.07 * s : 0;
        return p;
      };
      DiscPair pair(plugin, values(infinite_friction), 1.2, 0.8, pose(0));
      const double before = pair.energy();
      double work = 0;
      for (int k = 1; k <= 1000; ++k) {
        const Vec2 force = pair.force();
        const double torque = pair.torque_a();
        const DiscPose from = pair.pose(), to = pose(k / 1000.0);
        pair.follow([&](double) { return to; }, 1);
        work += 0.5 * (dot(force, to.a - from.a) + dot(pair.force(), to.a - from.a)) +
                0.5 * (torque + pair.torque_a()) * (to.angle_a - from.angle_a);
      }
      REQUIRE(pair.energy() - before > 0.1);
      CHECK(-work == Approx(pair.energy() - before).epsilon(1e-3));
    }
}

TEST_CASE("slip moves the painted points and keeps the rolling distance", "[disc]") {
  constexpr double friction = 0.2;
  DiscPair pair("disc_angular", values(friction), 1.2, 0.8, at(1.9, 0));
  const auto turned = [](double angle) {
    DiscPose p = at(1.9, 0);
    p.angle_a = angle;
    return p;
  };
  const double longest = friction * 100 * 0.1 / 80;  // μ k δ/k_t
  pair.follow([&](double s) { return turned(0.1 * s); }, 10);
  CHECK(pair.spring() == Approx(-longest).epsilon(1e-13));
  CHECK(pair.torque_a() == Approx(-1.2 * friction * 100 * 0.1).epsilon(1e-13));
  CHECK(pair.rolling() == Approx(-0.5 * 1.2 * 0.1).epsilon(1e-13));
  // Backwards the spring shortens at once.
  pair.follow([&](double s) { return turned(0.1 - 0.01 * s); }, 1);
  CHECK(pair.spring() == Approx(-longest + 1.2 * 0.01).epsilon(1e-12));
}

TEST_CASE("discs that roll on each other keep their spring, and count the rolling distance", "[disc]") {
  // Around b and three times across the jump of the polar angle: a rolls on b, which is held.
  constexpr double turn = -7 * pi, radius_a = 0.7, radius_b = 0.9, distance = 1.59;
  const auto pose = [&](double s) {
    DiscPose p = at(distance, 1 + turn * s);
    p.angle_a = (radius_a + radius_b) / radius_a * turn * s;
    return p;
  };
  DiscPair pair("disc_angular", values(infinite_friction), radius_a, radius_b, pose(0));
  pair.follow(pose, 100);
  // Angles of up to 16π are rounded to 7e-15.
  CHECK(std::abs(pair.spring()) < 2e-14);
  // ½ (R_a (Θ − θ_a) − R_b Θ) = −R_b Θ.
  CHECK(pair.rolling() == Approx(-radius_b * turn).epsilon(1e-14));
}

TEST_CASE("a wall is the limit of a large disc", "[disc]") {
  constexpr double large = 1e6;
  for (const std::string plugin : {"disc_angular", "disc_corrected", "disc_cundall_strack"})
    for (const std::string normal : {"overlap", "area"}) {
      INFO(plugin << ", " << normal);
      const auto on_wall = [](double s) {
        return DiscPose{.a = {{0.1 * s, 1.15 - 0.05 * s}}, .angle_a = -0.04 * s};
      };
      const auto on_disc = [&](double s) {
        DiscPose p = on_wall(s);
        p.b = {{0, -large}};
        return p;
      };
      DiscPair wall(plugin, values(infinite_friction, normal), 1.2, 0, on_wall(0));
      DiscPair disc(plugin, values(infinite_friction, normal), 1.2, large, on_disc(0));
      wall.follow(on_wall, 100);
      disc.follow(on_disc, 100);
      // Curvature 1e-6/m, and positions of 1e6 m that are rounded to 1e-10 m.
      CHECK(disc.spring() == Approx(wall.spring()).epsilon(1e-5));
      CHECK(disc.torque_a() == Approx(wall.torque_a()).epsilon(1e-5));
      for (int k = 0; k < 2; ++k) CHECK(disc.force()[k] == Approx(wall.force()[k]).epsilon(1e-5));
    }
}

TEST_CASE("the normal force of `area` is in proportion to the overlap area", "[disc]") {
  // Of the quadrature: h up to z⁷ is exact; the next term is below 0.01 (δ/2R)⁸.
  for (const double overlap : {1e-6, 0.01, 0.1}) {
    const double ra = 1.2, rb = 0.8, d = ra + rb - overlap;
    const double ca = (d * d + ra * ra - rb * rb) / (2 * d * ra),
                 cb = (d * d + rb * rb - ra * ra) / (2 * d * rb);
    const auto segment = [](double r, double cosine) {
      const double half = std::acos(cosine);
      return r * r * (half - std::sin(half) * cosine);
    };
    const DiscPair pair("disc_angular", values(1, "area"), ra, rb, at(d, 0));
    // The differences of the closed form lose digits: 1e-16/(1 − cos) relative.
    const double lost = 1e-15 / std::pow(overlap, 1.5) + 1e-12;
    CHECK(pair.force()[0] == Approx(100 * (segment(ra, ca) + segment(rb, cb)) / (4 * 0.48)).epsilon(lost));

    const DiscPair wall("disc_angular", values(1, "area"), ra, 0, DiscPose{.a = {{0, ra - overlap}}});
    CHECK(wall.force()[1] == Approx(100 * segment(ra, (ra - overlap) / ra) / (4 * ra)).epsilon(lost));
  }
}

TEST_CASE("a law of discs is refused in 3D, with the cure", "[disc]") {
  CHECK_THROWS_WITH(LawBatch("disc_angular", values(0.2), 3),
                    Catch::Contains("disc_angular: a law of discs") && Catch::Contains("dimension = 2"));
}
