#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include <scree/branching.hpp>
#include <scree/error.hpp>
#include <scree/fields/frame_input.hpp>
#include <scree/plugin/sphere_volumes.hpp>

namespace scree::fields {

namespace {

Vec3 triple_of(const std::vector<double>& values, std::size_t i) {
  return {{values[3 * i], values[3 * i + 1], values[3 * i + 2]}};
}

void check_frame(const pictures::Frame& f) {
  const std::size_t n = f.particle_count(), c = f.contact_count();
  if (f.velocity.size() != 3 * n || f.force.size() != 3 * n)
    throw Error("", "has no velocities or forces of bodies", "give a particles_*.vtp that a run has written");
  const bool touched =
      std::any_of(f.coordination.begin(), f.coordination.end(), [](auto k) { return k > 0; });
  if (c == 0 && touched)
    throw Error("", "has no contacts, of which the stress is made",
                "put the contacts_*.vtp of the same step beside it, or give a state of the run");
  if (f.contact_a.size() != c || f.contact_b.size() != c || f.contact_force.size() != 3 * c ||
      f.contact_from.size() != 3 * c || f.contact_to.size() != 3 * c)
    throw Error("", "has contacts without ids or forces, as earlier versions wrote them",
                "give a state of the run");
}

std::vector<FieldBody> bodies_in(const pictures::Frame& f, const FrameFacts& facts) {
  std::vector<std::size_t> order(f.particle_count());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return f.id[a] < f.id[b]; });
  std::vector<FieldBody> bodies;
  for (const std::size_t i : order) {
    bodies.push_back({.id = f.id[i],
                      .radius = f.radius[i],
                      .position = triple_of(f.position, i),
                      .velocity = triple_of(f.velocity, i),
                      .force = triple_of(f.force, i)});
    facts.complete(bodies.back(), f.dimension);
  }
  return bodies;
}

std::uint32_t index_of(const std::vector<FieldBody>& bodies, std::int64_t id) {
  const auto at =
      std::lower_bound(bodies.begin(), bodies.end(), id,
                       [](const FieldBody& body, std::int64_t wanted) { return body.id < wanted; });
  if (at == bodies.end() || at->id != id)
    throw Error("", fmt::format("has a contact of body {}, which it has not", id),
                "give the two files of one step as the run wrote them");
  return std::uint32_t(at - bodies.begin());
}

}  // namespace

FrameFacts::FrameFacts(const State& state) : domain_(domain_of(state)) {
  for (const Body& body : present_bodies(state))
    bodies_[body.id] = {body.mass, body.fixed ? freedom::Mask(7) : freedom::Mask(body.held & 7)};
}

void FrameFacts::complete(FieldBody& body, int dimension) const {
  if (density_ > 0) {
    body.mass = density_ * volume_of_sphere(dimension, body.radius);
    return;
  }
  const auto at = bodies_.find(body.id);
  if (at == bodies_.end())
    throw Error("", fmt::format("has the body {}, which the state has not", body.id),
                "give the --state of the same run");
  body.mass = at->second.mass;
  body.held = at->second.held;
}

FieldInput input_of_frame(const pictures::Frame& frame, const FrameFacts& facts) {
  check_frame(frame);
  FieldInput input = {
      .dimension = frame.dimension, .time = frame.time, .step = frame.step, .domain = facts.domain()};
  input.bodies = bodies_in(frame, facts);
  for (FieldBody& body : input.bodies) body.body_force = body.force;
  for (std::size_t c = 0; c < frame.contact_count(); ++c) {
    FieldContact contact = {.a = index_of(input.bodies, frame.contact_a[c]),
                            .line = triple_of(frame.contact_from, c) - triple_of(frame.contact_to, c),
                            .force = triple_of(frame.contact_force, c)};
    input.bodies[contact.a].body_force -= contact.force;
    if (frame.contact_b[c] >= 0) {
      contact.b = index_of(input.bodies, frame.contact_b[c]);
      input.bodies[contact.b].body_force += contact.force;
    }
    input.contacts.push_back(contact);
  }
  return input;
}

}  // namespace scree::fields
