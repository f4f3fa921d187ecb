#include "impact.hpp"
#include "setups.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

// What holds for all laws, over the grid of laws and impacts.

using namespace setups;

namespace {

std::vector<Law> laws(double restitution, Tension tension) {
  std::vector<Law> all;
  for (const History history : {History::displacement, History::rescaled, History::potential})
    all.push_back(hertz(restitution, tension, history));
  Law law = linear(restitution, tension);
  all.push_back(law);
  law.tangential_damping = 0.3;
  law.tangential_stiffness = 0.8 * stiffness;
  all.push_back(law);
  law.dynamic_friction = 0.05;
  all.push_back(law);
  law.dynamic_friction.reset();
  law.slip_rule = SlipRule::total;
  all.push_back(law);
  return all;
}

// The spin number 3 lies out of the plane of impact and turns the slip direction.
Vector spin(int number, int dimension) {
  if (dimension == 2) return {0, 0, number == 0 ? 0 : number == 1 ? 150. : number == 2 ? -150. : 300.};
  return number == 0   ? Vector{}
         : number == 1 ? Vector{0, 150, 0}
         : number == 2 ? Vector{0, -300, 0}
                       : Vector{150, 75, 50};
}

std::vector<Impact> impacts(const Law& law) {
  std::vector<Impact> all;
  for (const double friction : {0.1, 0.5})
    for (const double angle : {0., 20., 50., 75., 87.})
      for (const int dimension : {2, 3})
        for (const int number : {0, 1, 2, 3})
          for (Impact impact : {on_wall(law, angle, 1, dimension), on_body(law, angle, 1, dimension)}) {
            impact.law.friction = friction;
            impact.a.spin = spin(number, dimension);
            all.push_back(impact);
          }
  return all;
}

Vector momentum(const Body& a, const std::variant<Body, Wall>& other) {
  const Body& b = std::get<Body>(other);
  return a.mass * a.velocity + b.mass * b.velocity;
}

Vector angular_momentum(const Body& a, const std::variant<Body, Wall>& other) {
  const Body& b = std::get<Body>(other);
  return a.mass * cross(a.position, a.velocity) + b.mass * cross(b.position, b.velocity) +
         a.inertia() * a.spin + b.inertia() * b.spin;
}

void check_balance(const Impact& impact) {
  const Outcome o = integrate(impact);
  REQUIRE(o.touched);
  const double energy = kinetic_energy(impact.a, impact.other);
  const Dissipation& d = o.dissipated;
  const double spent = d.normal + d.tangential + d.friction + d.release - o.created;
  // A hundred steps, each exact to 1e-11.
  CHECK(o.energy_residual < 1e-9);
  CHECK(std::abs(kinetic_energy(o.a, o.other) + spent - energy) < 1e-9 * energy);
  // Rounding below zero where the dissipation is nothing.
  CHECK(std::min({d.normal, d.tangential, d.release, o.created}) > -1e-14 * energy);
  // With the rule `total` the spring slips against its force while the dashpot pulls harder than the limit.
  if (impact.law.slip_rule == SlipRule::spring) CHECK(d.friction > -1e-14 * energy);
  if (impact.law.history != History::displacement || impact.law.kind == LawKind::linear)
    CHECK(o.created == 0);
  if (std::holds_alternative<Wall>(impact.other)) return;
  // Rounding, as the two forces are opposite and the arms together as long as the distance of the centres;
  // the lines of action agree to the exactness of the positions.
  CHECK(norm(momentum(o.a, o.other) - momentum(impact.a, impact.other)) < 1e-13 * mass);
  CHECK(norm(angular_momentum(o.a, o.other) - angular_momentum(impact.a, impact.other)) <
        1e-12 * mass * radius);
}

Body turned(Body body) {
  // A turn about an axis along none of the coordinates, of which every component mixes with every other.
  const auto turn = [](const Vector& v) {
    const Vector axis = direction(Vector{0.3, -0.7, 0.5});
    return std::cos(1.1) * v + std::sin(1.1) * cross(axis, v) + ((1 - std::cos(1.1)) * dot(axis, v)) * axis;
  };
  body.position = turn(body.position);
  body.velocity = turn(body.velocity);
  body.spin = turn(body.spin);
  return body;
}

}  // namespace

TEST_CASE("energy is balanced, no dissipation negative, momentum conserved") {
  const double e = GENERATE(1.0, 0.8, 0.5, 0.3);
  const Tension tension = GENERATE(Tension::allowed, Tension::cut);
  for (const Law& law : laws(e, tension))
    for (const Impact& impact : impacts(law)) {
      CAPTURE(e, tension, law.kind, law.history, law.slip_rule, impact.law.friction, impact.a.dimension);
      CAPTURE(impact.a.velocity.x, impact.a.spin.x, impact.a.spin.y, impact.a.spin.z, impact.other.index());
      check_balance(impact);
    }
}

TEST_CASE("a thousand times smaller tolerance and another limit of the stiff direction change little") {
  const double e = GENERATE(1.0, 0.5);
  const Tension tension = GENERATE(Tension::allowed, Tension::cut);
  for (const Law& law : laws(e, tension))
    for (Impact impact : impacts(law)) {
      const Outcome coarse = integrate(impact, 1e-8), fine = integrate(impact, 1e-11);
      impact.relaxed_limit *= 100;
      const Outcome relaxed = integrate(impact, 1e-11);
      const auto difference = [&](const Outcome& other) {
        return std::abs(other.normal_impulse - fine.normal_impulse) +
               norm(other.tangential_impulse - fine.tangential_impulse);
      };
      CHECK(difference(coarse) < 1e-7 * fine.normal_impulse);
      CHECK(difference(relaxed) < 1e-9 * fine.normal_impulse);
    }
}

TEST_CASE("the axes do not matter, nor which body is the first") {
  for (const Law& law : laws(0.7, Tension::cut)) {
    for (const Impact& impact : impacts(law)) {
      if (impact.a.dimension == 2 || std::holds_alternative<Wall>(impact.other)) continue;
      const Outcome plain = integrate(impact);
      Impact changed = impact;
      changed.a = turned(std::get<Body>(impact.other));
      changed.other = turned(impact.a);
      const Outcome outcome = integrate(changed);
      const Body expected = turned(plain.a), &found = std::get<Body>(outcome.other);
      CHECK(norm(found.velocity - expected.velocity) < 1e-9);
      CHECK(norm(found.spin - expected.spin) < 1e-9 / radius);
      CHECK(norm(found.position - expected.position) < 1e-9 * radius);
    }
  }
}
