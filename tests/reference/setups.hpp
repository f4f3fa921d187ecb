#pragma once

#include "impact.hpp"

#include <numbers>
#include <string>

// Impacts for the tests of the reference.
namespace setups {

using namespace reference;

inline constexpr double radius = 0.005, mass = 1.3e-3, stiffness = 1e4;

inline double radians(double degrees) { return degrees * std::numbers::pi / 180; }

inline Law linear(double restitution, Tension tension) {
  Law law;
  law.kind = LawKind::linear;
  law.tension = tension;
  law.restitution = restitution;
  law.normal_stiffness = stiffness;
  law.tangential_stiffness = 2.0 / 7 * stiffness;
  return law;
}

inline Law hertz(double restitution, Tension tension, History history) {
  Law law;
  law.kind = LawKind::hertz;
  law.tension = tension;
  law.restitution = restitution;
  law.youngs_modulus = 1e8;
  law.poissons_ratio = 0.3;
  law.history = history;
  return law;
}

// A body that touches the wall z = 0 (in two dimensions y = 0), at an angle from the normal towards x.
inline Impact on_wall(const Law& law, double angle = 0, double speed = 1, int dimension = 3) {
  const Vector up = dimension == 2 ? Vector{0, 1, 0} : Vector{0, 0, 1};
  Impact impact;
  impact.law = law;
  impact.a = {dimension, radius, mass, radius * up, {}, {}};
  impact.a.velocity = speed * (Vector{std::sin(radians(angle)), 0, 0} - std::cos(radians(angle)) * up);
  impact.other = Wall{{}, up};
  return impact;
}

// The same, on a smaller body that lies off the axis of approach.
inline Impact on_body(const Law& law, double angle = 0, double speed = 1, int dimension = 3) {
  Impact impact = on_wall(law, angle, speed, dimension);
  const Vector up = std::get<Wall>(impact.other).normal;
  const Vector n = direction(up - 0.3 * Vector{1, 0, 0} + (dimension == 2 ? 0 : 0.2) * Vector{0, 1, 0});
  Body b{dimension, 0.6 * radius, 0.4 * mass, {}, 0.1 * impact.a.velocity, {}};
  b.spin = dimension == 2 ? Vector{0, 0, 20} : Vector{30, 10, -20};
  b.position = impact.a.position - (1.01 * (impact.a.radius + b.radius)) * n;
  impact.other = b;
  return impact;
}

inline double kinetic_energy(const Body& body) {
  return 0.5 * body.mass * dot(body.velocity, body.velocity) +
         0.5 * body.inertia() * dot(body.spin, body.spin);
}

inline double kinetic_energy(const Body& a, const std::variant<Body, Wall>& other) {
  const Body* b = std::get_if<Body>(&other);
  return kinetic_energy(a) + (b ? kinetic_energy(*b) : 0);
}

// Of the surface of a sphere where it touches the wall z = 0, as for small overlaps.
inline double slip_along_x(const Body& a) { return a.velocity.x - a.radius * a.spin.y; }

}  // namespace setups
