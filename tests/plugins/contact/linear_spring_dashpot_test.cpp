#include "contacts/contacts.hpp"
#include "scenes.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

// Two-body collisions against the closed forms of David et al. 2005, [D1]-[D4].

using namespace scree;
using namespace scree::test;
using std::numbers::pi;

namespace {

constexpr double bead_radius = 0.005, bead_mass = 1e-3, bead_stiffness = 5000;

struct Outcome {
  double restitution, contact_time;
};

// Head-on collision of two equal spheres. The contact time is interpolated between the steps around δ = 0.
Outcome collide(const Values& law, double step, double start_gap, double speed = 0.1) {
  const double x = bead_radius + 0.5 * start_gap;
  Simulation s(scene(3, step,
                     {body(1, bead_radius, bead_mass, {{-x, 0, 0}}, {{speed / 2, 0, 0}}),
                      body(2, bead_radius, bead_mass, {{x, 0, 0}}, {{-speed / 2, 0, 0}})},
                     law));
  const auto overlap = [&] { return 2 * bead_radius - norm(position(s, 0) - position(s, 1)); };
  double before = overlap(), began = NAN, ended = NAN;
  const double patience = start_gap / speed + 30 * pi * std::sqrt(bead_mass / 2 / bead_stiffness);
  while (std::isnan(ended) && s.time() < patience) {
    s.step();
    const double now = overlap();
    const double crossing = s.time() - step * now / (now - before);
    if (before <= 0 && now > 0) began = crossing;
    if (before > 0 && now <= 0) ended = crossing;
    before = now;
  }
  return {(velocity(s, 1)[0] - velocity(s, 0)[0]) / speed, ended - began};
}

// t_c and r of two spheres of mass m with damping coefficient γ.
Outcome closed_form(double damping) {
  const double m = bead_mass / 2, eta = damping / (2 * m), omega = std::sqrt(bead_stiffness / m - eta * eta);
  return {std::exp(-eta * pi / omega), pi / omega};
}

// Largest error over starts that vary the phase of first touch, and over steps that vary that of parting,
// within a step.
Outcome largest_error(const Values& law, double steps_per_contact, const Outcome& exact, double speed = 0.1) {
  Outcome worst = {0, 0};
  for (int k = 0; k < 64; ++k) {
    const double step = exact.contact_time / (steps_per_contact + (k / 8) / 8.0);
    const Outcome o = collide(law, step, speed * step * (3 + (k % 8) / 8.0), speed);
    worst.restitution = std::max(worst.restitution, std::abs(o.restitution - exact.restitution));
    worst.contact_time = std::max(worst.contact_time, std::abs(o.contact_time / exact.contact_time - 1));
  }
  return worst;
}

}  // namespace

TEST_CASE("restitution and contact time of [D1] hold to 1e-3 at a fiftieth of the contact", "[restitution]") {
  // The bound is usual for a step of t_c/50; the corners of the force at first touch and parting alone
  // contribute (ωΔt)²/8 = 5e-4.
  for (const double damping : {0.05, 0.2, 0.5}) {
    const Outcome exact = closed_form(damping);
    const Outcome error =
        largest_error({{"normal_stiffness", {bead_stiffness}}, {"normal_damping", {damping}}}, 50, exact);
    INFO("γ = " << damping << " kg/s, r = " << exact.restitution);
    CHECK(error.restitution < 1e-3);
    CHECK(error.contact_time < 1e-3);
  }
}

TEST_CASE("restitution and contact time converge at second order", "[restitution]") {
  const double damping = 0.5;
  const Outcome exact = closed_form(damping);
  const Values law = {{"normal_stiffness", {bead_stiffness}}, {"normal_damping", {damping}}};
  std::vector<Outcome> errors;
  for (const double steps : {25.0, 50.0, 100.0, 200.0, 400.0})
    errors.push_back(largest_error(law, steps, exact));
  // Fitted over a factor of 16: the phase of first touch makes single ratios scatter by tens of per cent,
  // which is below ±0.3 in the order over four halvings.
  const auto order = [&](double Outcome::*member) {
    return std::log2(errors.front().*member / (errors.back().*member)) / 4;
  };
  CHECK(order(&Outcome::restitution) == Approx(2).margin(0.3));
  CHECK(order(&Outcome::contact_time) == Approx(2).margin(0.3));
}

TEST_CASE("the given restitution is reached in both conventions, for every mass", "[restitution]") {
  for (const double tension : {0.0, 1.0})
    for (const double given : {0.1, 0.5, 0.9, 1.0}) {
      const Values law = {
          {"normal_stiffness", {bead_stiffness}}, {"restitution", {given}}, {"tension", {tension}}};
      const double step = pi / std::sqrt(2 * bead_stiffness / bead_mass) / 400;
      INFO("given " << given << ", tension " << (tension > 0 ? "cut" : "allowed"));
      // Step error: second order, (ωΔt)² = 6e-5, times the logarithmic decrement −ln r <= 2.3 and a factor of
      // a few.
      CHECK(collide(law, step, 0).restitution == Approx(given).margin(1e-3));
    }
}

TEST_CASE("cutting the tension at the same damping raises the restitution", "[restitution]") {
  const double ratio_for_half = std::log(2.0) / std::sqrt(pi * pi + std::log(2.0) * std::log(2.0));
  const double damping = 2 * ratio_for_half * std::sqrt(bead_stiffness * bead_mass / 2);
  const double step = pi / std::sqrt(2 * bead_stiffness / bead_mass) / 1000;
  const Values cut = {
      {"normal_stiffness", {bead_stiffness}}, {"normal_damping", {damping}}, {"tension", {1}}};
  // ζ = 0.2155: exp(−ζ/√(1−ζ²) (π − atan(2ζ√(1−ζ²)/(1−2ζ²)))) = 0.5500; the closed form is evaluated here
  // independently.
  const double z = ratio_for_half, root = std::sqrt(1 - z * z);
  const double expected = std::exp(-z / root * (pi - std::atan(2 * z * root / (1 - 2 * z * z))));
  CHECK(expected == Approx(0.550).margin(5e-4));
  CHECK(collide(cut, step, 0).restitution == Approx(expected).margin(1e-4));
}

TEST_CASE("the closed forms of describe reproduce the numbers of David et al.", "[closed-forms]") {
  const Parameters p = parameters("linear_spring_dashpot", SCREE_CONTACT_LAW,
                                  {{"normal_stiffness", {5000}}, {"normal_damping", {0.05}}});
  constexpr double no_box[3] = {};
  const ConfiguredLaw law(p, 3, no_box, no_box);
  const double m = 2000 * 4.0 / 3.0 * pi * std::pow(0.005, 3);
  const scree_encounter encounter = {m / 2, 0.0025, 1, 1};
  scree_closed_form forms[2];
  REQUIRE(law.interface().closed_forms(law.storage(), &encounter, forms, 2) == 2);
  CHECK(std::string(forms[0].name) == "contact_time");
  CHECK(forms[0].value == Approx(1.02e-3).margin(0.005e-3));  // as printed, to its last digit
  CHECK(forms[1].value == Approx(0.953).margin(0.0005));
}

TEST_CASE("a sphere thrown onto a plane slides, then rolls at 5/7 of its speed", "[friction]") {
  const double g = 9.81, friction = 0.3, speed = 1, m = bead_mass, k = 1e6;
  const double step = 1e-6;
  // At rest on the plane: overlap m g / k.
  Scene sc = scene(3, step, {body(1, bead_radius, m, {{0, 0, bead_radius - m * g / k}}, {{speed, 0, 0}})},
                   {{"normal_stiffness", {k}},
                    {"normal_damping", {1}},
                    {"tangential_stiffness", {k}},
                    {"tangential_damping", {1}},
                    {"static_friction", {friction}}});
  add_boundary(sc, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
  add_body_force(sc, "gravity", {{"acceleration", {0, 0, -g}}});
  Simulation s(sc);
  const double rolls_from = 2 * speed / (7 * friction * g);

  run(s, std::uint64_t(0.5 * rolls_from / step));
  // While sliding v = v0 − μ g t. The tangential spring first loads over a time of √(m/k), 3e-5 s, in which
  // the deceleration μ g is not yet reached: an error of at most μ g times that, 1e-4 m/s.
  CHECK(velocity(s, 0)[0] == Approx(speed - friction * g * s.time()).margin(1e-4));

  run(s, std::uint64_t(1.0 * rolls_from / step));
  // Rolling: v = ω (R − δ/2); the spring's oscillation at onset is damped by γ_t at a rate of about 1e3/s.
  CHECK(velocity(s, 0)[0] == Approx(5 * speed / 7).epsilon(1e-3));
  CHECK(s.particles().body(0).spin[1] * bead_radius == Approx(5 * speed / 7).epsilon(1e-3));
}

TEST_CASE("static and dynamic friction: stick until mu_s, then slide at mu_d until it sticks again",
          "[friction]") {
  // A sphere held by gravity on a plane that moves sideways slowly; a huge inertia keeps it from rolling.
  const double g = 10, m = 1, k_n = 1e5, k_t = 1e4, mu_s = 0.5, mu_d = 0.3, plane_speed = 0.01, step = 1e-4;
  Body heavy = body(1, 0.1, m, {{0, 0, 0.1 - m * g / k_n}});
  heavy.inertia = 1e12;
  Scene sc = scene(3, step, {heavy},
                   {{"normal_stiffness", {k_n}},
                    {"normal_damping", {0}},
                    {"tangential_stiffness", {k_t}},
                    {"static_friction", {mu_s}},
                    {"dynamic_friction", {mu_d}}});
  add_boundary(sc, "plane",
               {{"point", {0, 0, 0}},
                {"normal", {0, 0, 1}},
                {"direction", {1, 0, 0}},
                {"displacement", {3, 0, 10, 10 / plane_speed}}});
  add_body_force(sc, "gravity", {{"acceleration", {0, 0, -g}}});
  // Drag keeps it from moving with the plane.
  add_body_force(sc, "background_damping", {{"translational", {1e4}}});
  Simulation s(sc);
  double largest_sticking = 0, smallest_sliding = 1e9, largest_sliding = 0, smallest_begin = 1e9,
         largest_begin = 0;
  bool slid = false;
  for (int k = 0; k < 40000; ++k) {
    s.step();
    const ContactList c = s.contact_list();
    REQUIRE(c.size() == 1);
    const double ratio = std::abs(c.force[0]) / c.force[2];
    if (!c.sliding[0])
      largest_sticking = std::max(largest_sticking, ratio);
    else if (slid)
      smallest_sliding = std::min(smallest_sliding, ratio),
      largest_sliding = std::max(largest_sliding, ratio);
    else
      smallest_begin = std::min(smallest_begin, ratio), largest_begin = std::max(largest_begin, ratio);
    slid = c.sliding[0];
  }
  // The force grows by k_t v Δt = 0.01 N, 1e-3 of f_n, per step: it sticks up to μ_s within that amount, and
  // slides at μ_d.
  CHECK(largest_sticking <= mu_s * (1 + 1e-12));
  CHECK(largest_sticking > mu_s - 2e-3);
  CHECK(smallest_sliding == Approx(mu_d).epsilon(1e-12));
  CHECK(largest_sliding == Approx(mu_d).epsilon(1e-12));
  // In the step in which slip begins the force makes up for the moment at which it fell: by half of the fall.
  CHECK(smallest_begin >= mu_d - 0.5 * (mu_s - mu_d) - 1e-12);
  CHECK(largest_begin <= mu_d + 0.5 * (mu_s - mu_d) + 1e-12);
}

TEST_CASE("rotating a touching pair as a whole does not change the tangential spring", "[objectivity]") {
  // Two spheres pass each other with spins equal to the angular velocity of the line of centres: over a small
  // angle a rigid rotation. Springs are so soft that the bodies move nearly freely.
  const double rate = 5, distance = 2 * bead_radius - 0.02 * bead_radius, soft = 1e-9;
  const Vec3 spin = {{0, 0, rate}};
  const auto at = [&](double x) { return Vec3{{x, 0, 0}}; };
  Scene sc = scene(3, 1e-5,
                   {body(1, bead_radius, bead_mass, at(-distance / 2), cross(spin, at(-distance / 2)), spin),
                    body(2, bead_radius, bead_mass, at(distance / 2), cross(spin, at(distance / 2)), spin)},
                   {{"normal_stiffness", {soft}},
                    {"normal_damping", {0}},
                    {"tangential_stiffness", {soft}},
                    {"static_friction", {1e6}}});
  Simulation s(sc);
  run(s,
      100);  // 0.005 rad; straight flight opens the pair only by (0.005)²/2 of the distance, 1.3e-7 m of 1e-4
  const PairGroup& group = s.contacts().groups()[0];
  double spring = 0;
  for (std::uint32_t k = 0; k < 3; ++k) spring += std::pow(group.history.column(k)[0], 2);
  // The bodies move on straight lines, so the tangential motion differs from the rotation's by
  // d (θ − atan θ) = d θ³/3 = 4e-10 m; the arms, R − δ/2 for the present δ, follow the opening to
  // higher order.
  CHECK(std::sqrt(spring) < 4.2e-10);
}

TEST_CASE("a frictional collision conserves momentum and angular momentum to round-off", "[conservation]") {
  for (const int dimension : {2, 3}) {
    const Vec3 spin_a = dimension == 2 ? Vec3{{0, 0, 30}} : Vec3{{10, -20, 30}};
    const Vec3 offset = dimension == 2 ? Vec3{{0, 0.003, 0}} : Vec3{{0, 0.003, -0.002}};
    Scene sc = scene(dimension, 2e-6,
                     {body(1, bead_radius, bead_mass, {{-0.0045, 0, 0}}, {{1, 0.2, 0}}, spin_a, dimension),
                      body(2, 0.6 * bead_radius, 0.3 * bead_mass, Vec3{{0.0045, 0, 0}} + offset, {{-1, 0, 0}},
                           {}, dimension)},
                     {{"normal_stiffness", {bead_stiffness}},
                      {"normal_damping", {0.05}},
                      {"tangential_stiffness", {1000}},
                      {"tangential_damping", {0.01}},
                      {"static_friction", {0.4}}});
    Simulation s(sc);
    const Vec3 p0 = momentum(s), l0 = angular_momentum(s);
    const Vec3 v0 = velocity(s, 0);
    run(s, 3000);
    REQUIRE(norm(velocity(s, 0) - v0) > 0.1);  // they did collide
    // 3000 steps of round-off on 1e-3 kg m/s and on 5e-6 kg m²/s.
    CHECK(norm(momentum(s) - p0) < 3000 * 1e-16 * 1e-3);
    CHECK(norm(angular_momentum(s) - l0) < 3000 * 1e-16 * 5e-6);
  }
}

TEST_CASE("contradictory parameters are refused", "[parameters]") {
  const auto configure = [](const Values& values) {
    constexpr double no_box[3] = {};
    ConfiguredLaw(parameters("linear_spring_dashpot", SCREE_CONTACT_LAW, values), 3, no_box, no_box);
  };
  CHECK_THROWS_WITH(configure({{"normal_stiffness", {1}}}),
                    Catch::Contains("normal_damping") && Catch::Contains("restitution"));
  CHECK_THROWS_WITH(configure({{"normal_stiffness", {1}}, {"normal_damping", {1}}, {"restitution", {0.5}}}),
                    Catch::Contains("both"));
  CHECK_THROWS_WITH(configure({{"normal_damping", {1}}}), Catch::Contains("normal_stiffness"));
  CHECK_THROWS_WITH(
      configure({{"normal_stiffness", {1}}, {"normal_damping", {1}}, {"static_friction", {0.5}}}),
      Catch::Contains("tangential_stiffness"));
  CHECK_THROWS_WITH(configure({{"normal_stiffness", {1}},
                               {"normal_damping", {1}},
                               {"tangential_stiffness", {1e-300}},
                               {"tangential_damping", {0.03}},
                               {"static_friction", {0.5}}}),
                    Catch::Contains("too small"));
  CHECK_THROWS_WITH(configure({{"normal_stiffness", {-1}}, {"normal_damping", {1}}}),
                    Catch::Contains("above 0"));
}
