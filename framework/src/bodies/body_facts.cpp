#include "bodies/body_facts.hpp"

#include <algorithm>

#include <scree/state_transfer.hpp>

namespace scree {

Vec3 drift_of(const std::vector<Body>& bodies) {
  if (std::any_of(bodies.begin(), bodies.end(), [](const Body& b) { return b.fixed || b.held; })) return {};
  double mass = 0;
  Vec3 momentum = {};
  for (const Body& body : bodies) mass += body.mass, momentum += body.mass * body.velocity;
  return mass > 0 ? (1 / mass) * momentum : Vec3{};
}

BodyFacts facts_of(const std::vector<Body>& bodies, int dimension) {
  BodyFacts facts = {
      .count = bodies.size(), .bounds = bounds_of(bodies, dimension), .drift = drift_of(bodies)};
  double sum = 0;
  for (const Body& body : bodies) {
    sum += body.radius;
    facts.largest_radius = std::max(facts.largest_radius, body.radius);
    facts.smallest_radius = std::min(facts.smallest_radius, body.radius);
    facts.any_spins |= !(body.spin == Vec3{});
    facts.any_fixed |= body.fixed;
    facts.any_held |= body.held != 0;
  }
  facts.mean_radius = sum / std::max(1.0, double(bodies.size()));
  return facts;
}

void BodyFacts::transfer(const StateTransfer& state) {
  state.value("count", "", count);
  state.value("mean_radius", "m", mean_radius);
  state.value("largest_radius", "m", largest_radius);
  state.value("smallest_radius", "m", smallest_radius, stored::any);
  state.numbers("lower", "m", bounds.lower.component, 3);
  state.numbers("upper", "m", bounds.upper.component, 3);
  state.numbers("drift", "m/s", drift.component, 3);
  state.value("any_spins", "", any_spins);
  state.value("any_fixed", "", any_fixed);
  state.value("any_held", "", any_held);
}

}  // namespace scree
