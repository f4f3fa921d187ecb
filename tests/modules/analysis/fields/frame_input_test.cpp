#include "field_scenes.hpp"
#include "numbers.hpp"

#include <functional>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/fields/field_sums.hpp>
#include <scree/fields/frame_input.hpp>

using namespace scree;
using namespace scree::test;
using namespace scree::fields;

namespace {

std::vector<double> flat(const std::vector<Vec3>& vectors) {
  std::vector<double> numbers;
  for (const Vec3& v : vectors) numbers.insert(numbers.end(), v.component, v.component + 3);
  return numbers;
}

// The frame that a run would write, with the last body first.
pictures::Frame frame_of_input(const FieldInput& input) {
  pictures::Frame frame;
  frame.time = input.time, frame.step = input.step, frame.dimension = input.dimension;
  std::vector<Vec3> position, velocity, force, from, to, contact_force;
  for (auto body = input.bodies.rbegin(); body != input.bodies.rend(); ++body) {
    frame.id.push_back(body->id);
    frame.radius.push_back(body->radius);
    frame.coordination.push_back(1);
    position.push_back(body->position), velocity.push_back(body->velocity), force.push_back(body->force);
  }
  for (const FieldContact& c : input.contacts) {
    const bool wall = c.b == FieldContact::wall;
    frame.contact_a.push_back(input.bodies[c.a].id);
    frame.contact_b.push_back(wall ? -1 : input.bodies[c.b].id);
    frame.contact_normal_force.push_back(1);
    from.push_back(input.bodies[c.a].position);
    to.push_back(input.bodies[c.a].position - c.line);
    contact_force.push_back(c.force);
  }
  frame.position = flat(position), frame.velocity = flat(velocity), frame.force = flat(force);
  frame.contact_from = flat(from), frame.contact_to = flat(to), frame.contact_force = flat(contact_force);
  return frame;
}

std::string refused_frame(const std::function<void(pictures::Frame&)>& change) {
  pictures::Frame frame = frame_of_input(input_of(*agitated(packing_scenes[0], 1)));
  change(frame);
  try {
    input_of_frame(frame, FrameFacts(2500));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a frame has the fields of the state at its time, and body forces that contacts leave",
          "[fields]") {
  for (const std::size_t scene : {std::size_t(2), std::size_t(4), std::size_t(5)}) {
    const PackingScene& packing = packing_scenes[scene];
    CAPTURE(packing.name);
    const auto simulation = agitated(packing);
    const FieldInput input = input_of(*simulation);
    const FieldInput read = input_of_frame(frame_of_input(input), FrameFacts(simulation->state()));
    CHECK(read.time == input.time);
    CHECK(read.step == input.step);
    ThreadPool one(1);
    FieldSums of_state(grid_over(packing), AveragingKernel(packing.dimension, 2)), of_frame = of_state;
    of_state.add(input, one);
    of_frame.add(read, one);
    const std::vector<FieldPoint> a = of_state.means(), b = of_frame.means();
    CHECK(force_residual(b) < 1e-13);
    for (std::size_t k = 0; k < a.size(); ++k) {
      CHECK(b[k].density == a[k].density);
      CHECK(b[k].kinetic_stress == a[k].kinetic_stress);
      CHECK(b[k].holding_force == a[k].holding_force);
      for (std::size_t c = 0; c < 9; ++c)  // lines are differences of two places near 10
        CHECK(b[k].contact_stress[c] == Approx(a[k].contact_stress[c]).margin(1e-12));
      // Round-off of forces near 100.
      CHECK(norm(b[k].body_force - a[k].body_force - a[k].group_load) < 1e-12);
    }
  }
}

TEST_CASE("bodies of frames have the mass of their volume where a density is given", "[fields]") {
  const FieldInput input = input_of(*agitated(packing_scenes[0], 1));
  const FieldInput read = input_of_frame(frame_of_input(input), FrameFacts(2500));
  for (const FieldBody& body : read.bodies)
    CHECK(body.mass ==
          Approx(2500 * 4 * std::acos(-1.0) / 3 * std::pow(body.radius, 3)).epsilon(4 * epsilon));
  CHECK_FALSE(read.domain.any_periodic());
}

TEST_CASE("frames without what fields are made of are refused with a cure", "[fields]") {
  CHECK(refused_frame([](pictures::Frame&) {}).empty());
  CHECK_THAT(refused_frame([](pictures::Frame& f) { f.force.clear(); }),
             Catch::StartsWith("has no velocities or forces of bodies; give"));
  CHECK_THAT(refused_frame([](pictures::Frame& f) { f.contact_force.clear(); }),
             Catch::StartsWith("has contacts without ids or forces, as earlier versions wrote them; give"));
  CHECK_THAT(
      refused_frame([](pictures::Frame& f) {
        for (auto* column : {&f.contact_normal_force, &f.contact_force, &f.contact_from, &f.contact_to})
          column->clear();
        f.contact_a.clear(), f.contact_b.clear();
      }),
      Catch::StartsWith("has no contacts, of which the stress is made; put the contacts_*.vtp"));
  CHECK_THAT(refused_frame([](pictures::Frame& f) { f.contact_b[0] = 99999; }),
             Catch::StartsWith("has a contact of body 99999, which it has not; give"));
  const auto simulation = agitated(packing_scenes[0], 1);
  pictures::Frame frame = frame_of_input(input_of(*simulation));
  frame.id[0] = 5000;
  CHECK_THROWS_WITH(input_of_frame(frame, FrameFacts(simulation->state())),
                    "has the body 5000, which the state has not; give the --state of the same run");
}
