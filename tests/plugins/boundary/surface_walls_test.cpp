#include "wall_support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/wall_surfaces.hpp>

// Bodies on cylinders, cones, discs, rectangles and spheres, against closed forms and planes.

using namespace scree;
using namespace scree::test;
using std::numbers::pi;

namespace {

constexpr double gravity = 9.81;
const Values rolling_law = {{"normal_stiffness", {1e6}},
                            {"normal_damping", {0}},
                            {"tangential_stiffness", {1e6}},
                            {"static_friction", {10}}};
const Values sliding_law = {{"normal_stiffness", {1e5}},
                            {"restitution", {0.7}},
                            {"tangential_stiffness", {3e4}},
                            {"static_friction", {0.4}}};

void add_gravity(Scene& s, const Vec3& acceleration) {
  add_body_force(s, "gravity", {{"acceleration", {acceleration[0], acceleration[1], acceleration[2]}}});
}

// Times (s) at which a number goes through 0 from below, between steps linearly.
std::vector<double> rises(Simulation& s, int steps, const std::function<double(const Simulation&)>& number) {
  std::vector<double> times;
  double before = number(s);
  for (int k = 0; k < steps; ++k) {
    s.step();
    const double now = number(s);
    if (before < 0 && now >= 0) times.push_back(s.time() - s.step_length() * now / (now - before));
    before = now;
  }
  return times;
}

// What a surface and the bodies exert on each other, about the origin.
struct Balance {
  Vec3 force = {}, torque = {};
};
Balance contact_loads(const Simulation& s) {
  Balance sum;
  const Particles& p = s.particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3 x = position(s, i),
               f = {{p.force()[0][i], p.force()[1][i], p.dimension() == 2 ? 0 : p.force()[2][i]}};
    Vec3 t = {};
    for (int k = p.spin_axes().first; k < 3; ++k) t[k] = p.torque()[k][i];
    sum.force += f;
    sum.torque += t + cross(x, f);
  }
  const WallSurfaces& surfaces = s.surfaces();
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    const auto vector = [](const double(&v)[3]) { return Vec3{{v[0], v[1], v[2]}}; };
    const Vec3 f = vector(surfaces.loads[k].force);
    sum.force += f;
    sum.torque += vector(surfaces.loads[k].torque) + cross(vector(surfaces.frames[k].position), f);
  }
  return sum;
}

}  // namespace

// ω² = 5 g/(7 (R − r)) of small swings of a rolling sphere, and T = 2π/ω (1 + φ²/16) to second order in the
// amplitude φ. The overlap m g/k = 4e-5 m makes R − r larger by as much, a part of 1e-4 of 0.4 m; tangential
// springs are 1e-4 m long.
TEST_CASE("a sphere rolls to and fro in a cylinder as its equation of motion says", "[surfaces]") {
  constexpr double hollow = 0.5, radius = 0.1, mass = 4, amplitude = 0.05;
  const double arm = hollow - radius;
  for (const Vec3& axis : {Vec3{{0, 1, 0}}, Vec3{{0.6, 0.8, 0}}}) {
    // Swings across the axis.
    const Vec3 across = {{axis[1], -axis[0], 0}};
    Scene sc = scene(3, 2e-5,
                     {body(1, radius, mass,
                           arm * std::sin(amplitude) * across + Vec3{{0, 0, -arm * std::cos(amplitude)}})},
                     rolling_law);
    add_boundary(
        sc, "cylinder",
        {{"point", {0, 0, 0}}, {"axis", {axis[0], axis[1], axis[2]}}, {"radius", {hollow}}, {"side", {2}}});
    add_gravity(sc, {{0, 0, -gravity}});
    Simulation s(sc);
    const auto times = rises(s, 160000, [&](const Simulation& now) { return dot(position(now, 0), across); });
    REQUIRE(times.size() >= 2);
    const double period = 2 * pi * std::sqrt(7 * arm / (5 * gravity)) * (1 + amplitude * amplitude / 16);
    CHECK((times.back() - times.front()) / double(times.size() - 1) == Approx(period).epsilon(1e-3));
    // Verlet keeps the energy of the contact, ω = 500/s, to (ω h)²/8.
    CHECK(s.energy_residual() < 1.3e-5);
    CHECK(s.momentum_residual() < 1e-12);
  }
}

// ω² = g/(h tan² α) without friction, at the height h of the point of contact above the apex; the bead's
// centre is r/sin α above the apex of a cone that is parallel to the wall and goes through the centre, which
// replaces h.
TEST_CASE("a bead circles in a cone", "[surfaces]") {
  constexpr double radius = 0.01, mass = 0.01, angle = 0.5, height = 0.3;
  const double speed = std::sqrt(gravity * height), ring = height * std::tan(angle);
  // The centre lies on a cone of the same angle that begins r/sin(α) above the apex.
  const double centre = height + radius / std::sin(angle);
  Scene sc = scene(3, 1e-5, {body(1, radius, mass, {{ring, 0, centre}}, {{0, speed, 0}})},
                   {{"normal_stiffness", {1e6}}, {"normal_damping", {0}}});
  add_boundary(sc, "cone",
               {{"point", {0, 0, 0}},
                {"axis", {0, 0, 1}},
                {"radius", {0}},
                {"end_radius", {std::tan(angle)}},
                {"length", {1}},
                {"side", {2}}});
  add_gravity(sc, {{0, 0, -gravity}});
  Simulation s(sc);
  const auto times = rises(s, 150000, [](const Simulation& now) { return position(now, 0)[1]; });
  REQUIRE(times.size() >= 2);
  const double turns = double(times.size() - 1);
  // Elastic: an overlap of 2e-7 m of 0.3 m.
  CHECK((times.back() - times.front()) / turns == Approx(2 * pi * ring / speed).epsilon(1e-4));
  CHECK(position(s, 0)[2] == Approx(centre).epsilon(1e-4));
}

// Each step of a pair with a plane and with a flat surface does the same but for round-off, which grows with
// the number of impacts.
TEST_CASE("a flat surface moves bodies as a plane does", "[surfaces]") {
  const std::string follower = "sphere_path_independent";
  for (const auto& [dimension, law] : {std::pair<int, std::string>{2, "linear_spring_dashpot"},
                                       {3, "linear_spring_dashpot"},
                                       {3, follower}}) {
    const Vec3 n = dimension == 2 ? Vec3{{0.28, 0.96, 0}} : Vec3{{0.48, 0.36, 0.8}};
    const std::vector<double> normal(n.component, n.component + 3);
    const auto moved = [&, dimension = dimension, law = law](const std::string& plugin, Values values) {
      std::vector<Body> bodies;
      for (int i = 0; i < 5; ++i) {
        const Vec3 place = (0.011 + 0.002 * i) * n + Vec3{{0.05 * i, 0, 0}};
        bodies.push_back(body(i + 1, 0.01, 0.01, place - dot(place, n) * n + (0.0105 + 0.001 * i) * n,
                              {{0.3, -0.1 * i, dimension == 2 ? 0 : 0.2}},
                              {{dimension == 2 ? 0.0 : 3, dimension == 2 ? 0.0 : -5, 7}}, dimension));
      }
      Scene sc = scene(dimension, 1e-5, bodies, sliding_law, law);
      values.insert(values.begin(),
                    {{"point", {0, 0, 0}}, {"normal", normal}, {"velocity", {1, 0, 0.2, 30, 0}}});
      add_boundary(sc, plugin, values);
      add_gravity(sc, -gravity * n);
      Simulation s(sc);
      run(s, 8000);
      std::vector<Vec3> all;
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Body b = s.particles().body(i);
        all.insert(all.end(), {b.position, b.velocity, 0.01 * b.spin});
      }
      CHECK(s.energy_residual() < 1e-3);
      return all;
    };
    const std::vector<Vec3> expected = moved("plane", {{"control", {2}}});
    Values values = {{"length", {100}}};
    if (dimension == 3) values.insert(values.end(), {{"along", {1, 0, 0}}, {"width", {90}}});
    std::vector<std::pair<std::string, Values>> others = {{"rectangle", values}};
    if (dimension == 3) others.push_back({"disc", {{"radius", {50}}}});
    for (const auto& [plugin, own] : others) {
      INFO(plugin << " in " << dimension << "D, " << law);
      const std::vector<Vec3> found = moved(plugin, own);
      for (std::size_t k = 0; k < found.size(); ++k) CHECK(norm(found[k] - expected[k]) < 1e-12);
    }
  }
}

TEST_CASE("what surfaces and bodies exert on each other is opposite, forces and torques", "[surfaces]") {
  for (const auto& [dimension, law] : {std::pair<int, std::string>{2, "linear_spring_dashpot"},
                                       {3, "linear_spring_dashpot"},
                                       {3, "sphere_path_independent"}}) {
    INFO(dimension << "D, " << law);
    std::vector<Body> bodies;
    for (int i = 0; i < 12; ++i)
      bodies.push_back(body(i + 1, 0.05, 0.1,
                            {{0.11 * (i % 4) - 0.16, 0.11 * (dimension == 2 ? i / 4 : i / 4 % 2) - 0.05,
                              dimension == 2 ? 0 : 0.11 * (i / 8) - 0.05}},
                            {{0.3, -0.2, dimension == 2 ? 0 : 0.1}}, {{0, 0, 2}}, dimension));
    Scene sc = scene(dimension, 1e-5, bodies, sliding_law, law);
    add_boundary(sc, "cylinder",
                 {{"point", {0.01, 0.02, 0}},
                  {"axis", {0, 0, 1}},
                  {"radius", {0.3}},
                  {"side", {2}},
                  {"spin", {3, 0, 8, 0.2}}});
    if (dimension == 3) {
      add_boundary(sc, "disc",
                   {{"point", {0, 0, -0.15}}, {"normal", {0, 0, 1}}, {"radius", {1}}, {"spin", {-3}}});
      add_boundary(sc, "disc", {{"point", {0, 0, 0.15}}, {"normal", {0, 0, 1}}, {"radius", {1}}});
    }
    add_gravity(sc, {{0, -gravity, 0}});
    Simulation s(sc);
    double largest = 0;
    for (int k = 0; k < 20; ++k) {
      run(s, 1000);
      Balance sum = contact_loads(s);
      for (std::size_t i = 0; i < bodies.size(); ++i) {  // without weights
        sum.force += Vec3{{0, 0.1 * gravity, 0}};
        sum.torque += cross(position(s, i), Vec3{{0, 0.1 * gravity, 0}});
      }
      CHECK(norm(sum.force) < 1e-11);
      CHECK(norm(sum.torque) < 1e-12);
      largest = std::max(largest, norm(Vec3{{s.surfaces().loads[0].torque[2], 0, 0}}));
    }
    CHECK(largest > 0.01);
    CHECK(s.energy_residual() < 1e-3);
    CHECK(s.momentum_residual() < 1e-12);
  }
}

// A sphere that lies on a turning disc off its axis rolls along a circle with 2/7 of the spin: the closed
// form of a ball on a turntable (Weckesser, Am. J. Phys. 65, 736 (1997)).
TEST_CASE("a ball on a turntable circles with 2/7 of its spin", "[surfaces]") {
  constexpr double radius = 0.02, spin = 3, place = 0.1, mass = 0.1;
  // Starts in rolling motion about the origin: v = 2/7 Ω × x.
  const double speed = 2.0 / 7 * spin * place;
  // No slip: v + ω × (−r z) = Ω × x.
  const double turning = (speed - spin * place) / radius;
  Scene sc = scene(3, 4e-5,
                   {body(1, radius, mass, {{place, 0, radius - mass * gravity / 1e6}}, {{0, speed, 0}},
                         {{turning * -1, 0, 0}})},
                   rolling_law);
  add_boundary(sc, "disc", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"radius", {1}}, {"spin", {spin}}});
  add_gravity(sc, {{0, 0, -gravity}});
  Simulation s(sc);
  // The overlap is 5e-5 of the radius, springs are 7e-9 m long: the bounds have margins of 20 and more.
  const auto times = rises(s, 200000, [](const Simulation& now) { return position(now, 0)[1]; });
  REQUIRE(!times.empty());
  CHECK(times.back() / double(times.size()) == Approx(2 * pi / (2.0 / 7 * spin)).epsilon(1e-3));
  CHECK(norm(position(s, 0) - Vec3{{0, 0, position(s, 0)[2]}}) == Approx(place).epsilon(1e-2));
}

// A ball rolls along a trough whose axis is periodic: three periods are as far as in a long trough, also if
// the trough is as long as the period, whose ends the ball passes before it is folded. Places differ by the
// round-off of the period.
TEST_CASE("springs follow bodies on a surface across periodic faces", "[surfaces]") {
  const auto rolled = [](bool periodic, bool endless, const std::string& law) {
    constexpr double radius = 0.02, mass = 0.1;
    Scene sc = scene(3, 4e-5, {body(1, radius, mass, {{0.03, 0.05, -0.07418}}, {{0, 1, 0}}, {{3, 0, -2}})},
                     sliding_law, law);
    if (periodic) add_boundary(sc, "periodic", {{"axes", {1}}, {"lower", {0, 0, 0}}, {"upper", {0, 0.1, 0}}});
    Values trough = {{"point", {0, endless ? 0 : 0.05, 0}},
                     {"axis", {0, 1, 0}},
                     {"radius", {0.1}},
                     {"side", {2}},
                     {"spin", {0.5}}};
    if (!endless) trough.push_back({"length", {0.1}});
    add_boundary(sc, "cylinder", trough);
    add_gravity(sc, {{0, 0, -gravity}});
    sc.skin = 0.004;
    Simulation s(sc);
    run(s, 10000);
    CHECK(s.energy_residual() < 1e-3);
    const Body b = s.particles().body(0);
    return std::array<Vec3, 3>{b.position, b.velocity, radius * b.spin};
  };
  for (const std::string law : {"linear_spring_dashpot", "sphere_path_independent"}) {
    const std::array<Vec3, 3> expected = rolled(false, true, law);
    REQUIRE(expected[0][1] > 0.3);
    for (const bool endless : {true, false}) {
      INFO(law << ", endless " << endless);
      std::array<Vec3, 3> found = rolled(true, endless, law);
      found[0][1] += 0.1 * std::floor((expected[0][1] - found[0][1]) / 0.1 + 0.5);
      for (std::size_t k = 0; k < 3; ++k) CHECK(norm(found[k] - expected[k]) < 1e-11);
    }
  }
}

TEST_CASE("surfaces that cannot be are refused by name", "[surfaces]") {
  const auto problem = [](const std::string& plugin, const Values& values, int dimension = 3,
                          const std::string& law = "linear_spring_dashpot") {
    Scene sc = scene(dimension, 1e-5, {body(1, 0.01, 0.01, {{0.5, 0.5, 0}}, {}, {}, dimension)},
                     law == "linear_spring_dashpot" ? sliding_law
                                                    : Values{{"normal_stiffness", {1e5}},
                                                             {"normal_damping", {0}},
                                                             {"tangential_stiffness", {3e4}},
                                                             {"friction", {0.4}}},
                     law);
    sc.orientations = law != "linear_spring_dashpot";
    try {
      add_boundary(sc, plugin, values);
      Simulation s(sc);
      s.step();
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  const Values at = {{"point", {0, 0, 0}}};
  const auto with = [&](Values values) {
    values.insert(values.end(), at.begin(), at.end());
    return values;
  };
  CHECK_THAT(problem("disc", with({{"normal", {0, 0, 1}}, {"radius", {1}}, {"hole", {1}}})),
             Catch::Contains("hole is not below radius"));
  CHECK_THAT(problem("disc", with({{"normal", {0, 0, 0}}, {"radius", {1}}})),
             Catch::Contains("has length 0"));
  CHECK_THAT(problem("disc", with({{"normal", {0, 1, 0}}, {"radius", {1}}}), 2),
             Catch::Contains("choose rectangle"));
  CHECK_THAT(problem("rectangle", with({{"normal", {0, 0, 1}}, {"along", {0, 0, 2}}, {"length", {1}}})),
             Catch::Contains("along is parallel to the normal"));
  CHECK_THAT(problem("rectangle", with({{"normal", {0, 0, 1}}, {"length", {1}}})),
             Catch::Contains("along is missing"));
  CHECK_THAT(problem("sphere", with({{"radius", {1}}, {"low", {2}}})),
             Catch::Contains("leave nothing of the sphere"));
  CHECK_THAT(problem("cone", with({{"axis", {0, 0, 1}}, {"radius", {0}}, {"length", {1}}})),
             Catch::Contains("both radii are 0"));
  CHECK_THAT(problem("cylinder", with({{"radius", {1}}, {"length", {1}}}), 2),
             Catch::Contains("leave it out"));
  CHECK_THAT(problem("cylinder", with({{"radius", {1}}, {"velocity", {1}}}), 2),
             Catch::Contains("a motion without direction in a 2D scene"));
  CHECK_THAT(problem("cylinder", with({{"radius", {1}}, {"spin_point", {1, 0, 0}}})),
             Catch::Contains("spin_point without spin"));
  CHECK_THAT(problem("cylinder", with({{"radius", {0.3}}, {"side", {2}}})),
             Catch::Contains("its centre is 0.407 m behind the surface cylinder"));
  CHECK_THAT(problem("cylinder", with({{"radius", {1}}}), 2, "disc_angular"),
             Catch::Contains("which it cannot on surface cylinder; choose a law with springs"));
}
