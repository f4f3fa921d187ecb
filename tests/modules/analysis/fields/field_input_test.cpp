#include "field_scenes.hpp"
#include "numbers.hpp"

#include <catch2/catch.hpp>

#include <scree/fields/field_input.hpp>

using namespace scree;
using namespace scree::test;
using fields::FieldBody;
using fields::FieldContact;
using fields::FieldInput;

namespace {

// Load of each body from contacts, body forces and groups.
std::vector<Vec3> loads_of(const FieldInput& input) {
  std::vector<Vec3> loads;
  for (const FieldBody& b : input.bodies) loads.push_back(b.body_force + b.group_load);
  for (const FieldContact& c : input.contacts) {
    loads[c.a] += c.force;
    if (c.b != FieldContact::wall) loads[c.b] -= c.force;
  }
  return loads;
}

}  // namespace

TEST_CASE("the loads of bodies are those of contacts, body forces and groups", "[fields]") {
  for (const PackingScene& packing : packing_scenes) {
    CAPTURE(packing.name);
    const auto simulation = agitated(packing, 20);
    const FieldInput before = fields::input_of(*simulation);
    simulation->step();
    // The step has evaluated drag at predicted velocities.
    const FieldInput input = fields::input_after_step(*simulation, {&before, 1});
    CHECK(input.step == 21);
    const std::vector<Vec3> loads = loads_of(input);
    double largest = 0, open = 0;
    for (std::size_t i = 0; i < loads.size(); ++i) {
      largest = std::max(largest, norm(loads[i]));
      open = std::max(open, norm(loads[i] - input.bodies[i].force));
      if (i > 0) CHECK(input.bodies[i - 1].id < input.bodies[i].id);
    }
    CHECK(largest > 10);
    // Sums of at most 13 forces, which may be ten times as large as their sum.
    CHECK(open < 13 * 10 * epsilon * largest);
  }
}

TEST_CASE("drag and position_verlet leave forces of another time", "[fields]") {
  CHECK(fields::forces_are_present(*agitated(packing_scenes[0], 3)));
  CHECK(fields::forces_are_present(*agitated(packing_scenes[4], 3)));
  CHECK_FALSE(fields::forces_are_present(*agitated(packing_scenes[6], 3)));  // with damping
  Scene scene = scene_of(packing_scenes[0]);
  scene.integration = Integration::position_verlet;
  CHECK_FALSE(fields::forces_are_present(Simulation(scene)));
}

TEST_CASE("the line of a contact ends at the centres, or on the wall", "[fields]") {
  const PackingScene packing = {"", 3, {0, 1}};
  const auto simulation = agitated(packing, 20);
  const FieldInput input = fields::input_of(*simulation);
  int walls = 0, across = 0;
  for (const FieldContact& c : input.contacts) {
    Vec3 start = input.bodies[c.a].position - c.line;
    if (c.b == FieldContact::wall) {
      const double height = 4 * pitch;
      CHECK(std::min(std::abs(start[2]), std::abs(start[2] - height)) < 20 * epsilon * height);
      ++walls;
      continue;
    }
    Vec3 apart = start - input.bodies[c.b].position;
    for (int k = 0; k < 2; ++k) {
      const double period = input.domain.length(k), images = std::round(apart[k] / period);
      across += images != 0;
      apart[k] -= images * period;
    }
    CHECK(norm(apart) < 1e-13);
  }
  CHECK(walls > 5);
  CHECK(across > 5);
}

TEST_CASE("held components and loads of groups are those of the scene", "[fields]") {
  const PackingScene packing = {"", 3, {}, true};
  const auto simulation = agitated(packing, 20);
  const FieldInput input = fields::input_of(*simulation);
  const Scene scene = scene_of(packing);
  const double load = 2 + 4 * std::sin(2 * std::acos(-1.0) * 5 * simulation->time());
  for (const FieldBody& b : input.bodies) {
    const auto i = std::size_t(1000 - b.id) / 7;
    CHECK(b.held == (scene.bodies[i].fixed ? 7 : scene.bodies[i].held));
    CHECK(b.group_load[1] == Approx(i == 12 || i == 17 || i == 20 ? load : 0).epsilon(1e-12));
  }
}
