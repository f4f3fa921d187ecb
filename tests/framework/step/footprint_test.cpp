#include "contacts/contacts.hpp"
#include "scenes.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

// A scene carries only the axes, spins, histories and images that it needs.

using scree::Footprint;
using scree::Particles;
using scree::Scene;
using scree::Simulation;

namespace {

struct Carries {
  int dimension = 3;
  bool friction = false, spinning = false, periodic = false, later_stage = false;
};

Scene scene_that(const Carries& c) {
  const scree::Vec3 spin = {{0, 0, c.spinning ? 1.0 : 0.0}};
  std::vector<scree::Body> bodies;
  for (int i = 0; i < 3; ++i)
    bodies.push_back(scree::test::body(i, 1, 1, {{1.9 * i, 0, 0}}, {}, spin, c.dimension));
  Scene s = scree::test::scene(c.dimension, 1e-4, bodies,
                               {{"normal_stiffness", {1e3}},
                                {"normal_damping", {1}},
                                {"tangential_stiffness", {1e3}},
                                {"static_friction", {c.friction ? 0.5 : 0}}});
  s.spin = c.later_stage;
  if (c.periodic)
    scree::test::add_boundary(s, "periodic", {{"axes", {0}}, {"lower", {-10, 0, 0}}, {"upper", {10, 0, 0}}});
  return s;
}

// The axes of which a vector of columns is allocated, as a bit each; all allocated ones have an element per
// body.
template <class Columns>
unsigned axes_of(const Columns& columns, std::size_t bodies) {
  unsigned axes = 0;
  for (int k = 0; k < 3; ++k) {
    CHECK((columns[k].empty() || columns[k].size() == bodies));
    if (!columns[k].empty()) axes |= 1u << k;
  }
  return axes;
}

void check(const Carries& c) {
  CAPTURE(c.dimension, c.friction, c.spinning, c.periodic, c.later_stage);
  const bool spin = c.friction || c.spinning || c.later_stage, flat = c.dimension == 2;
  Simulation s(scene_that(c));
  scree::test::run(s, 3);
  const Particles& p = s.particles();
  const unsigned axes = flat ? 0b011 : 0b111, spin_axes = !spin ? 0 : flat ? 0b100 : 0b111;
  for (const auto& vectors : {p.position(), p.velocity(), p.mid_velocity(), p.force()})
    CHECK(axes_of(vectors, p.size()) == axes);
  for (const auto& vectors : {p.spin(), p.mid_spin(), p.torque()})
    CHECK(axes_of(vectors, p.size()) == spin_axes);
  CHECK(axes_of(p.image, p.size()) == (c.periodic ? axes : 0));
  CHECK(p.inertia.size() == (spin ? p.size() : 0));

  const std::size_t dimension = std::size_t(c.dimension), spins = !spin ? 0 : flat ? 1 : 3;
  const Footprint footprint = s.footprint();
  CHECK(footprint.degrees_of_freedom == p.size() * (dimension + spins));
  // 32 bytes each for position, velocity, mid-step velocity and force, in 3D with spin also for spin,
  // mid-step spin and torque; mass, inertia, images, id and material.
  const std::size_t records = 4 + (spin && !flat ? 3 : 0), images = c.periodic ? dimension : 0;
  CHECK(footprint.bytes_per_body == 32 * records + (spin ? 16 : 8) + 4 * images + 8 + 4);
  // A spring component per axis, and the sliding state.
  CHECK(footprint.listed_pairs == 2);
  CHECK(footprint.history_width == (c.friction ? dimension + 1 : 0));
  // Two bodies, an image, a slot for each of the bodies at 4 bytes; force, sum of the radii, and the root of
  // the reduced mass, which the law reads.
  const std::size_t indices =
      sizeof(s.contacts().a[0]) + sizeof(s.contacts().b[0]) + sizeof(s.contacts().image[0]);
  const std::size_t doubles = dimension + 2 + footprint.history_width;
  CHECK(footprint.bytes_per_pair >= indices + doubles * sizeof(double));
  CHECK(footprint.bytes_per_pair <= indices + 2 * sizeof(std::uint32_t) + doubles * sizeof(double));
  for (const scree::PairGroup& group : s.contacts().groups()) {
    CHECK(group.end - group.begin == 2);
    CHECK(group.history.size() == footprint.history_width * group.padded_size());
  }
}

}  // namespace

TEST_CASE("a frictionless scene carries no spin and no history, a 2D one no z") {
  for (const int dimension : {2, 3}) check({.dimension = dimension});
}

TEST_CASE("friction adds spins and springs") {
  for (const int dimension : {2, 3}) check({.dimension = dimension, .friction = true});
}

TEST_CASE("spinning bodies, or a later stage with friction, add spins but no springs") {
  for (const int dimension : {2, 3}) {
    check({.dimension = dimension, .spinning = true});
    check({.dimension = dimension, .later_stage = true});
  }
}

TEST_CASE("periodic scenes carry image counters") {
  for (const int dimension : {2, 3})
    for (const bool friction : {false, true})
      check({.dimension = dimension, .friction = friction, .periodic = true});
}

TEST_CASE("what a scene does not carry reads as zero") {
  const Simulation s(scene_that({.dimension = 2}));
  const scree::Body body = s.particles().body(1);
  CHECK(body.position[2] == 0);
  CHECK(body.velocity[2] == 0);
  CHECK(body.spin == scree::Vec3{});
}

TEST_CASE("records, loads and histories begin on a cache line") {
  const Simulation s(scene_that({.friction = true}));
  const auto aligned = [](const void* p) { return reinterpret_cast<std::uintptr_t>(p) % 64 == 0; };
  CHECK(aligned(s.particles().records()));
  CHECK(aligned(s.particles().loads()));
  for (const scree::PairGroup& group : s.contacts().groups())
    for (std::uint32_t k = 0; k < group.history_width; ++k) CHECK(aligned(group.history.column(k)));
}
