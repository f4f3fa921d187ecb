#include "coefficients.hpp"
#include "impact.hpp"
#include "setups.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

// The reference, which switches between equations of sticking and sliding, against many small steps of a
// spring that is cut back to the Coulomb limit: the same law without a word of directions and switches.

using namespace setups;

namespace {

// A sphere on the wall z = 0 in so many equal steps, each of the first order.
Body stepped(const Impact& impact, int steps, double duration) {
  const Law& law = impact.law;
  const Coefficients forces(law, mass, radius);
  Body a = impact.a;
  Vector stretch;
  double stiffness_before = forces.tangential_stiffness(0);
  bool slides = false;
  const double dt = duration / steps;
  for (int i = 0; i < steps; ++i) {
    a.position = a.position + dt * a.velocity;
    const double overlap = std::max(radius - a.position.z, 0.0), arm = radius - 0.5 * overlap;
    const Vector n = {0, 0, 1};
    const Vector v = a.velocity - arm * cross(a.spin, n), v_t = v - v.z * n;
    const double law_force = forces.elastic_force(overlap) - forces.normal_damping(overlap) * v.z;
    const double pressing = std::max(law_force, 0.0), k_t = forces.tangential_stiffness(overlap);
    if (law.history == History::rescaled && v.z < 0 && k_t > 0) stretch = (stiffness_before / k_t) * stretch;
    stiffness_before = k_t;
    stretch = stretch + dt * v_t;
    const double still = law.friction * pressing,
                 moving = law.dynamic_friction.value_or(law.friction) * pressing;
    slides = k_t * norm(stretch) > (slides ? moving : still);
    const double limit = slides ? moving : still;
    if (slides) stretch = (limit / k_t) * direction(stretch);
    Vector f_t = -(k_t * stretch + forces.tangential_damping(overlap) * v_t);
    if (norm(f_t) > limit) f_t = limit * direction(f_t);
    double f_n = law.tension == Tension::cut ? std::max(law_force, 0.0) : law_force;
    if (law.history == History::potential)
      f_n += 0.5 * forces.tangential_stiffness_slope(overlap) * dot(stretch, stretch);
    if (overlap == 0) continue;
    a.velocity = a.velocity + (dt / mass) * (f_n * n + f_t);
    a.spin = a.spin - (dt * arm / a.inertia()) * cross(n, f_t);
  }
  return a;
}

}  // namespace

TEST_CASE("many small steps of the cut-back spring come to the same") {
  const Tension tension = GENERATE(Tension::cut, Tension::allowed);
  const double e = GENERATE(0.9, 0.5), friction = GENERATE(0.1, 0.4);
  std::vector<Law> laws = {linear(e, tension)};
  laws[0].tangential_damping = 0.5;
  laws.push_back(laws[0]);
  laws[1].dynamic_friction = 0.4 * friction;
  for (const History history : {History::displacement, History::rescaled, History::potential})
    laws.push_back(hertz(e, tension, history));
  for (const Law& law : laws)
    for (const double angle : {20., 50., 70.}) {
      Impact impact = on_wall(law, angle);
      impact.law.friction = friction;
      impact.a.spin = {150, 75, 50};
      const Outcome outcome = integrate(impact);
      const int steps = 20000;
      const Body found = stepped(impact, steps, 1.05 * outcome.contact_time);
      CAPTURE(e, friction, angle, law.kind, law.history, tension, outcome.switches);
      // Of first order: errors of some parts in the number of steps.
      CHECK(norm(found.velocity - outcome.a.velocity) < 10.0 / steps);
      CHECK(norm(found.spin - outcome.a.spin) < 10.0 / steps / radius);
    }
}
