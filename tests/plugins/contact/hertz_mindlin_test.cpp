#include "law_batch.hpp"
#include "scenes.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

// Two-body collisions of Hertz–Mindlin contacts against closed forms; Chung & Ooi, Granular Matter 13, 643,
// tests 1 to 3.

using namespace scree;
using namespace scree::test;

namespace {

double sphere_mass(double density, double radius) {
  return density * 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3);
}

struct Impact {
  double largest_overlap = 0, largest_force = 0, contact_time = 0, restitution = 0;
};

// Head-on impact of two equal spheres, or of one on a plane, with this number of steps in the contact.
Impact impact_of_spheres(double youngs, double poisson, double density, double radius, double speed,
                         bool on_plane, double steps, const Values& more = {}) {
  Values law = {{"youngs_modulus", {youngs}}, {"poissons_ratio", {poisson}}};
  if (on_plane) law.push_back({"other_youngs_modulus", {1e30}});
  law.insert(law.end(), more.begin(), more.end());
  const double m = sphere_mass(density, radius), reduced = on_plane ? m : m / 2,
               r = on_plane ? radius : radius / 2;
  const double modulus = youngs / (1 - poisson * poisson) / (on_plane ? 1 : 2);
  const double relative = on_plane ? speed : 2 * speed;
  const double step =
      2.8682656992 * std::pow(reduced * reduced / (r * modulus * modulus * relative), 0.2) / steps;
  std::vector<Body> bodies = {body(1, radius, m, {{radius + 0.25 * step * speed, 0, 0}}, {{-speed, 0, 0}})};
  if (!on_plane)
    bodies.push_back(body(2, radius, m, {{-radius - 0.25 * step * speed, 0, 0}}, {{speed, 0, 0}}));
  Scene sc = scene(3, step, bodies, law, "hertz_mindlin");
  if (on_plane) add_boundary(sc, "plane", {{"point", {0, 0, 0}}, {"normal", {1, 0, 0}}});
  Simulation s(sc);
  Impact impact;
  double began = 0;
  for (int k = 0; k < 20 * steps; ++k) {
    s.step();
    const ContactList c = s.contact_list();
    if (c.size() == 0 && began > 0) break;
    if (c.size() == 0) continue;
    if (began == 0) began = s.time() - c.overlap[0] / relative;
    impact.largest_overlap = std::max(impact.largest_overlap, c.overlap[0]);
    impact.largest_force = std::max(impact.largest_force, std::abs(c.force[0]));
    impact.contact_time = s.time() + c.overlap[0] / relative - began;
  }
  impact.restitution = velocity(s, 0)[0] / speed;
  return impact;
}

}  // namespace

TEST_CASE("Chung & Ooi 1 to 3: overlap, force and time of elastic impacts", "[hertz]") {
  struct Case {
    const char* name;
    double youngs, poisson, density, radius, speed;
    bool on_plane;
    double overlap, force, time;
  };
  const Case cases[] = {
      {"glass spheres", 4.8e10, 0.20, 2800, 0.010, 10, false, 2.741127e-4, 1.069689e4, 4.033946e-5},
      {"limestone spheres", 2.0e10, 0.25, 2500, 0.010, 10, false, 3.683040e-4, 7.108241e3, 5.420100e-5},
      {"aluminium on a rigid wall", 7.0e10, 0.30, 2699, 0.1, 0.2, true, 4.971718e-5, 1.136986e4,
       7.316566e-4}};
  for (const Case& c : cases) {
    const double steps = 2000;
    const Impact impact =
        impact_of_spheres(c.youngs, c.poisson, c.density, c.radius, c.speed, c.on_plane, steps);
    INFO(c.name);
    // Step error: (π/steps)² = 2.5e-6 from the integrator and as much because the largest overlap is between
    // two steps; the contact time is known to the end of the last step, whose speed differs from the first by
    // (Δt/t_c)^1.
    CHECK(impact.largest_overlap == Approx(c.overlap).epsilon(5e-6));
    CHECK(impact.largest_force == Approx(c.force).epsilon(7.5e-6));
    CHECK(impact.contact_time == Approx(c.time).epsilon(1e-5));
    CHECK(impact.restitution == Approx(1).epsilon(5e-6));
  }
}

TEST_CASE("the given restitution is reached at every speed, in both conventions", "[hertz]") {
  for (const double tension : {0.0, 1.0})
    for (const double given : {0.1, 0.5, 0.95, 1.0})
      for (const double speed : {0.01, 1.0, 100.0}) {
        INFO("e = " << given << ", " << speed << " m/s, tension " << (tension > 0 ? "cut" : "allowed"));
        const Impact impact = impact_of_spheres(4.8e10, 0.2, 2800, 0.01, speed, false, 1000,
                                                {{"restitution", {given}}, {"tension", {tension}}});
        // (ωΔt)² = 1e-5 times the logarithmic decrement, at most 2.3.
        CHECK(impact.restitution == Approx(given).margin(2.3e-5));
      }
}

TEST_CASE("[L2]-[L5] for one contact, by hand", "[hertz]") {
  const double Y = 65e9, nu = 0.25, beta = 0.0163, R = 2e-4, m = 3e-7, delta = 1e-7;
  const double e = std::exp(-beta * std::numbers::pi / std::sqrt(1 - beta * beta));
  CHECK(e == Approx(0.950).margin(5e-4));
  const double E = Y / (2 * (1 - nu * nu)), G = Y / (4 * (2 - nu) * (1 + nu));
  for (const double form : {0.0, 1.0, 2.0}) {
    LawBatch c("hertz_mindlin", {{"youngs_modulus", {Y}},
                                 {"poissons_ratio", {nu}},
                                 {"restitution", {e}},
                                 {"friction", {0.22}},
                                 {"history", {form}}});
    c.set(SCREE_NORMAL, {{0, 1, 0}});
    c.input(SCREE_OVERLAP) = delta;
    c.input(SCREE_REDUCED_MASS) = m;
    c.input(SCREE_EFFECTIVE_RADIUS) = R;
    const Vec3 v = {{1e-4, 2e-4, 0}}, xi = {{1e-9, 0, 2e-9}};
    c.set(SCREE_RELATIVE_VELOCITY, v);
    c.set(SCREE_TANGENTIAL_INCREMENT, xi);
    c.evaluate(1e-12);
    const double k_n = 4.0 / 3.0 * E * std::sqrt(R * delta), k_t = 8 * G * std::sqrt(R * delta);
    const double gamma_n = 2 * beta * std::pow(R * delta, 0.25) * std::sqrt(5.0 / 3.0 * m * E);
    const double gamma_t = 4 * beta * std::pow(R * delta, 0.25) * std::sqrt(10.0 / 6.0 * m * G);
    // The spring afterwards: rescaled, 2/3 of the displacement, the mean of √δ since first touch.
    const Vec3 spring = (form == 1 ? 2.0 / 3 : 1.0) * xi;
    const double extra = form == 2 ? 0.25 * k_t / delta * dot(spring, spring) : 0;
    INFO("history form " << form);
    CHECK(c.force()[1] == Approx(k_n * delta - gamma_n * v[1] + extra).epsilon(1e-12));
    CHECK(c.force()[0] == Approx(-k_t * spring[0] - gamma_t * v[0]).epsilon(1e-12));
    CHECK(c.force()[2] == Approx(-k_t * spring[2]).epsilon(1e-12));
    CHECK(c.output(SCREE_ELASTIC_NORMAL) ==
          Approx(8.0 / 15.0 * E * std::sqrt(R) * std::pow(delta, 2.5)).epsilon(1e-12));
    CHECK(c.output(SCREE_ELASTIC_TANGENTIAL) == Approx(0.5 * k_t * dot(spring, spring)).epsilon(1e-12));
  }
}

TEST_CASE("dashpots correct the overshoot of the predicted velocity, a fraction ½ h² K/m*", "[damping]") {
  const double m = 1e-3, R = 5e-3, delta = 1e-5, v = -0.3, Y = 1e9;
  const auto force = [&](const std::string& plugin, const Values& law, double h) {
    LawBatch c(plugin, law);
    c.set(SCREE_NORMAL, {{0, 0, 1}});
    c.set(SCREE_RELATIVE_VELOCITY, {{0, 0, v}});
    c.input(SCREE_OVERLAP) = delta, c.input(SCREE_REDUCED_MASS) = m, c.input(SCREE_EFFECTIVE_RADIUS) = R;
    c.evaluate(h);
    return c.force()[2];
  };
  // K = dF/dδ: of the linear spring k, of Hertz' 2 E* √(R* δ), with E* = Y/2 here.
  const double k = 2e4, hertz_stiffness = Y * std::sqrt(R * delta);
  const Values linear = {{"normal_stiffness", {k}}, {"restitution", {0.5}}};
  const Values hertz = {{"youngs_modulus", {Y}}, {"poissons_ratio", {0}}, {"restitution", {0.5}}};
  struct Case {
    const char* plugin;
    const Values& law;
    double stiffness, elastic;
  };
  for (const Case& c : {Case{"linear_spring_dashpot", linear, k, k * delta},
                        Case{"hertz_mindlin", hertz, hertz_stiffness, 2.0 / 3 * hertz_stiffness * delta}})
    for (const double h : {1e-5, 1e-4, -1e-4}) {
      const double whole = force(c.plugin, c.law, 0) - c.elastic,
                   damped = force(c.plugin, c.law, h) - c.elastic;
      INFO(c.plugin << ", step " << h);
      REQUIRE(whole > 0);
      CHECK(damped / whole == Approx(1 / (1 + 0.5 * h * h * c.stiffness / m)).epsilon(1e-10));
    }
}

TEST_CASE("tangential springs under cyclic overlap: which forms create energy", "[hertz]") {
  // A loop in (δ, ξ): load δ, shear, unload δ, shear back. The work of a force law that has a potential
  // vanishes.
  const auto work_of_loop = [](double form) {
    LawBatch c(
        "hertz_mindlin",
        {{"youngs_modulus", {1e9}}, {"poissons_ratio", {0.25}}, {"friction", {1e9}}, {"history", {form}}});
    c.set(SCREE_NORMAL, {{0, 1, 0}});
    c.input(SCREE_REDUCED_MASS) = c.input(SCREE_EFFECTIVE_RADIUS) = 1;
    const double low = 1e-3, high = 2e-3, shear = 1e-4;
    double delta = low, work = 0;
    c.input(SCREE_OVERLAP) = delta;
    c.evaluate(1);
    const auto move = [&](double change, double slide) {
      constexpr int parts = 2000;
      for (int k = 0; k < parts; ++k) {
        const Vec3 before = c.force();
        delta += change / parts;
        c.input(SCREE_OVERLAP) = delta;
        c.set(SCREE_TANGENTIAL_INCREMENT, {{slide / parts, 0, 0}});
        c.evaluate(1);
        const Vec3 mean = 0.5 * (before + c.force());
        work += -mean[1] * change / parts + mean[0] * slide / parts;  // of the contact on the bodies
      }
    };
    move(0, shear), move(high - low, 0), move(0, -shear), move(low - high, 0);
    return work /
           (0.5 * 8 * 1e9 / (4 * 1.75 * 1.25) * std::sqrt(low) * shear * shear);  // over the spring's energy
  };
  // Trapezoidal sums over 2000 parts of curves that bend by a factor of 1.4: (1/2000)²/12.
  CHECK(std::abs(work_of_loop(2)) < 1e-6);
  // Displacement: sheared at low δ, unsheared at high δ, it returns √2 times the work done on it: energy is
  // created.
  CHECK(work_of_loop(0) == Approx(std::sqrt(2.0) - 1).epsilon(1e-3));
  // Rescaled: the force is kept while k_t grows, so that the return path starts from ξ = shear/√2; energy is
  // only dissipated.
  CHECK(work_of_loop(1) <= 1e-6);
}

TEST_CASE("rolling resistance: constant torque against the relative spin, none at rest", "[hertz]") {
  LawBatch c("hertz_mindlin", {{"youngs_modulus", {1e9}},
                               {"poissons_ratio", {0.25}},
                               {"friction", {0.3}},
                               {"rolling_friction", {0.01}}});
  c.set(SCREE_NORMAL, {{0, 0, 1}});
  c.input(SCREE_OVERLAP) = 1e-4;
  c.input(SCREE_EFFECTIVE_RADIUS) = 0.01;
  c.input(SCREE_REDUCED_MASS) = 1;
  c.set(SCREE_RELATIVE_SPIN, {{3, 4, 0}});
  c.evaluate(1e-9);
  const double force = 4.0 / 3.0 * 1e9 / (2 * (1 - 0.0625)) * std::sqrt(0.01 * 1e-4) * 1e-4;
  CHECK(c.output(SCREE_COUPLE, 0) == Approx(-0.01 * force * 0.01 * 0.6));
  CHECK(c.output(SCREE_COUPLE, 1) == Approx(-0.01 * force * 0.01 * 0.8));
  c.set(SCREE_RELATIVE_SPIN, {});
  c.evaluate(1e-9);
  CHECK(c.output(SCREE_COUPLE, 0) == 0);
  CHECK(c.output(SCREE_COUPLE, 1) == 0);
}

TEST_CASE("small relative spins are calmed in rolling_time, or in 16 steps where these are longer",
          "[hertz]") {
  LawBatch c("hertz_mindlin", {{"youngs_modulus", {1e9}},
                               {"poissons_ratio", {0.25}},
                               {"friction", {0.3}},
                               {"rolling_friction", {0.01}},
                               {"rolling_time", {1e-3}}});
  c.set(SCREE_NORMAL, {{0, 0, 1}});
  c.input(SCREE_OVERLAP) = 1e-4;
  c.input(SCREE_EFFECTIVE_RADIUS) = 0.01;
  c.input(SCREE_REDUCED_MASS) = 2;
  c.set(SCREE_RELATIVE_SPIN, {{1e-3, 0, 0}});
  const double inertia = 0.4 * 2 * 0.01 * 0.01;
  for (const double step : {1e-9, 1e-6, 1e-3 / 16, 1e-4}) {
    c.evaluate(step);
    CHECK(c.output(SCREE_COUPLE, 0) == Approx(-inertia * 1e-3 / std::max(1e-3, 16 * step)).epsilon(1e-14));
  }
}
