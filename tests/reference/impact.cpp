#include "impact.hpp"

#include "passage.hpp"

#include <algorithm>
#include <stdexcept>

namespace reference {

namespace {

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

Body flown(Body body, double time) {
  body.position = body.position + time * body.velocity;
  return body;
}

std::variant<Body, Wall> flown(const std::variant<Body, Wall>& other, double time) {
  if (const Body* body = std::get_if<Body>(&other)) return flown(*body, time);
  return other;
}

double gap(const Body& a, const std::variant<Body, Wall>& other) {
  if (const Body* b = std::get_if<Body>(&other)) return norm(a.position - b->position) - a.radius - b->radius;
  const Wall& wall = std::get<Wall>(other);
  return dot(direction(wall.normal), a.position - wall.point) - a.radius;
}

void check(const Impact& impact) {
  const auto check_body = [&](const Body& body) {
    require(body.radius > 0 && body.mass > 0, "radius and mass must be positive");
    require(body.dimension == 2 || body.dimension == 3, "the dimension is 2 or 3");
    require(body.dimension == impact.a.dimension, "both bodies have the same dimension");
    const bool flat = body.position.z == impact.a.position.z && body.velocity.z == 0 && body.spin.x == 0 &&
                      body.spin.y == 0;
    require(body.dimension == 3 || flat, "discs stay in a plane of constant z and spin about z");
  };
  check_body(impact.a);
  if (const Body* b = std::get_if<Body>(&impact.other)) check_body(*b);
  if (const Wall* wall = std::get_if<Wall>(&impact.other)) {
    require(norm(wall->normal) > 0, "a wall needs a normal");
    require(impact.a.dimension == 3 || wall->normal.z == 0,
            "a wall stands upright on the plane of the discs");
  }
  const double size = impact.a.radius;
  require(gap(impact.a, impact.other) > -1e-12 * size, "the bodies overlap from the start");
  require(std::is_sorted(impact.sample_times.begin(), impact.sample_times.end()), "sample times must rise");
}

// When the bodies touch first in free flight and the speed of approach then; a negative speed if they never
// do.
struct Touch {
  double time = 0, speed = -1;
};

Touch first_touch(const Body& a, const std::variant<Body, Wall>& other) {
  Touch touch;
  if (const Wall* wall = std::get_if<Wall>(&other)) {
    touch.speed = -dot(direction(wall->normal), a.velocity);
    if (touch.speed > 0) touch.time = gap(a, other) / touch.speed;
    return touch;
  }
  // |r + w t|² = (R_a + R_b)², the earlier time, without cancellation
  const Body& b = std::get<Body>(other);
  const Vector r = a.position - b.position, w = a.velocity - b.velocity;
  const double reach = a.radius + b.radius, towards = -dot(r, w);
  const double room = gap(a, other) * (norm(r) + reach);
  const double square = towards * towards - dot(w, w) * room;
  if (towards <= 0 || square <= 0) return touch;
  touch.time = room / (towards + std::sqrt(square));
  touch.speed = std::sqrt(square) / reach;
  return touch;
}

Sample sample_of(double time, const Body& a, const std::variant<Body, Wall>& other) {
  Sample sample;
  sample.time = time;
  sample.a = a;
  sample.other = other;
  sample.overlap = -gap(a, other);
  return sample;
}

Sample sample_of(double first_touch, const Motion& motion, const Passage::Record& record) {
  const auto& [state, branch] = record;
  const Instant now = motion.instant(state, branch);
  Sample sample = sample_of(first_touch + state[at::time], motion.body_a(state), motion.other(state));
  sample.overlap = now.overlap;
  sample.spring = now.stretch;
  sample.force = now.normal_force * now.normal + now.tangential_force;
  sample.sliding = branch.grip == Grip::slide || branch.grip == Grip::relaxed;
  return sample;
}

Outcome outcome_of(double first_touch, const Motion& motion, const Passage& passage) {
  const State& state = passage.state();
  Outcome result;
  result.touched = true;
  result.a = motion.body_a(state);
  result.other = motion.other(state);
  result.first_touch = first_touch;
  result.contact_time = state[at::time];
  result.pushing_time = passage.pushing_time();
  result.largest_overlap = passage.largest_overlap();
  result.normal_impulse = state[at::normal_impulse];
  result.tangential_impulse = get(state, at::tangential_impulse);
  result.dissipated = {state[at::normal], state[at::tangential], state[at::friction], state[at::release]};
  result.created = state[at::created];
  result.remaining_elastic = passage.remaining_elastic();
  result.slides = passage.slides();
  result.switches = passage.switches();
  result.energy_residual = passage.energy_residual();
  result.steps = passage.steps();
  for (const Passage::Record& record : passage.records())
    result.samples.push_back(sample_of(first_touch, motion, record));
  return result;
}

}  // namespace

Outcome integrate(const Impact& impact, double tolerance) {
  check(impact);
  const Touch touch = first_touch(impact.a, impact.other);
  const bool touches = touch.speed > 0;
  Outcome result;
  Passage::Settings settings{touch.speed, tolerance, impact.relaxed_limit};
  std::vector<Sample> before;
  for (const double time : impact.sample_times)
    if (!touches || time <= touch.time)
      before.push_back(sample_of(time, flown(impact.a, time), flown(impact.other, time)));
    else
      settings.sample_times.push_back(time - touch.time);
  if (touches) {
    Impact touching = impact;
    touching.a = flown(impact.a, touch.time);
    touching.other = flown(impact.other, touch.time);
    Motion motion(touching);
    Passage passage(motion, settings);
    passage.run();
    result = outcome_of(touch.time, motion, passage);
    for (const double time : impact.sample_times)
      if (const double late = time - touch.time - result.contact_time; late > 0)
        result.samples.push_back(sample_of(time, flown(result.a, late), flown(result.other, late)));
  }
  result.samples.insert(result.samples.begin(), before.begin(), before.end());
  return result;
}

}  // namespace reference
