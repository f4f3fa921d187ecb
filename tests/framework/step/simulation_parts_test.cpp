#include "contacts/contacts.hpp"
#include "state/heap.hpp"

#include <vector>

#include <catch2/catch.hpp>

#include <scree/plugin/program.hpp>
#include <scree/wall_surfaces.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// Where a simulation has its bodies, walls and contacts, as a packing at rest.
struct Present {
  std::vector<Vec3> bodies, planes;
  std::vector<std::vector<double>> histories;
  RestingPacking packing;

  explicit Present(const Simulation& s)
      : packing{s.time(), {}, {}, s.loads(), {}, {}, s.particles().orientations, {}} {
    const Particles& p = s.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
      bodies.push_back(p.body(i).position);
      for (int k = 0; k < p.dimension(); ++k)
        if (!p.image[k].empty()) bodies[i][k] += p.image[k][i] * s.domain().length(k);
    }
    for (const scree_plane& plane : s.planes())
      planes.push_back({{plane.point[0], plane.point[1], plane.point[2]}});
    const ContactList list = s.contact_list();
    for (std::size_t c = 0; c < list.size(); ++c) {
      histories.emplace_back();
      for (std::uint32_t k = 0; k < s.footprint().history_width; ++k)
        histories.back().push_back(s.contact_history(list.pair[c], k));
    }
    for (std::size_t c = 0; c < list.size(); ++c)
      packing.contacts.push_back({list.a[c], list.b[c], histories[c]});
    packing.bodies = bodies, packing.planes = planes;
  }
};

}  // namespace

TEST_CASE("a simulation that comes to rest where it is keeps its contacts and their springs") {
  const int dimension = GENERATE(2, 3);
  const bool periodic = GENERATE(false, true);
  const Scene scene = heap(dimension, periodic);
  Simulation moving(scene);
  run(moving, 90);
  Present present(moving);
  REQUIRE(!present.packing.contacts.empty());
  present.packing.time = 7.4 * scene.step;
  const Simulation resting(scene, moving.state_at_rest(present.packing));

  CHECK(resting.steps() == 7);
  CHECK(resting.energy().kinetic_translation == 0);
  CHECK(resting.energy().kinetic_rotation == 0);
  const ContactList before = moving.contact_list(), after = resting.contact_list();
  REQUIRE(after.a == before.a);
  REQUIRE(after.b == before.b);
  // Bodies beyond a periodic face are folded back when neighbours are searched for.
  for (std::size_t c = 0; c < before.size(); ++c)
    CHECK(after.overlap[c] == Approx(before.overlap[c]).epsilon(0).margin(1e-13));
  for (std::size_t c = 0; c < before.size(); ++c)
    for (std::uint32_t k = 0; k < moving.footprint().history_width; ++k)
      CHECK(resting.contact_history(after.pair[c], k) == moving.contact_history(before.pair[c], k));
}

// Each is moved by many skins, to where no pair is listed that it may touch.
TEST_CASE("bodies at rest elsewhere meet their new neighbours") {
  const Scene scene =
      test::scene(2, 1e-3, {body(0, 1, 1, {{0, 0, 0}}, {}, {}, 2), body(1, 1, 1, {{9, 0, 0}}, {}, {}, 2)},
                  {{"normal_stiffness", {1e4}}, {"normal_damping", {0}}});
  const Simulation apart(scene);
  Present present(apart);
  present.bodies[1] = {{2 + 1e-3, 0, 0}};
  const Simulation near(scene, apart.state_at_rest(present.packing));
  CHECK(near.contact_list().size() == 0);
  CHECK(near.rebuilds() == apart.rebuilds() + 1);
  CHECK(near.contacts().groups()[0].end - near.contacts().groups()[0].begin == 1);
}

TEST_CASE("a contact of bodies that are apart is refused") {
  const Scene scene =
      test::scene(2, 1e-3, {body(0, 1, 1, {}, {}, {}, 2), body(1, 1, 1, {{9, 0, 0}}, {}, {}, 2)},
                  {{"normal_stiffness", {1e4}}, {"normal_damping", {0}}});
  const Simulation apart(scene);
  Present present(apart);
  present.packing.contacts.push_back({0, 1, {}});
  CHECK(error_line([&] { apart.state_at_rest(present.packing); }) ==
        "bodies 0 and 1 do not touch where they are at rest; list only pairs that touch");
}

// A lid and a plane that move, whose boundaries keep speeds and places in their state.
TEST_CASE(
    "walls that come to rest elsewhere have no speeds, and the centres of their turns have moved with them",
    "[surfaces]") {
  Scene scene = test::scene(3, 1e-3, {body(0, 1, 1, {{0, 0, 0}})},
                            {{"normal_stiffness", {1e4}}, {"normal_damping", {0}}});
  add_boundary(scene, "disc",
               {{"point", {0, 0, 2}},
                {"normal", {0, 0, -1}},
                {"radius", {1}},
                {"force", {5}},
                {"mass", {2}},
                {"torque", {3}},
                {"inertia", {1}},
                {"spin_point", {0.5, 0, 2}}});
  add_boundary(scene, "plane",
               {{"point", {0, 0, -3}},
                {"normal", {0, 0, 1}},
                {"control", {4}},
                {"force", {0, 1}},
                {"mass", {2}},
                {"superposed", {Program::table, 0, 0, 10, 0}}},
               "plane");
  Simulation moving(scene);
  run(moving, 20);
  REQUIRE(moving.energy().kinetic_boundary > 0);
  Present present(moving);
  const Vec3 displacement = {{0, 0, -0.1}};
  const std::vector<Vec3> surfaces = {vector_of(moving.surfaces().frames[0].position) + displacement};
  present.packing.surfaces = surfaces;
  const State state = moving.state_at_rest(present.packing);
  const Simulation resting(scene, state);
  CHECK(resting.energy().kinetic_boundary == 0);
  const scree_frame& frame = resting.surfaces().frames[0];
  CHECK(vector_of(frame.position) == surfaces[0]);
  for (const double* v : {frame.velocity, frame.mid_velocity, frame.spin, frame.mid_spin})
    for (int k = 0; k < 3; ++k) CHECK(v[k] == 0);
  const auto numbers = [](const State& of, const char* path) {
    return std::get<std::vector<double>>(of.at(path).values);
  };
  const std::vector<double> now = numbers(state, "walls/0/state"),
                            before = numbers(moving.state(), "walls/0/state");
  for (std::size_t k = 0; k < now.size(); ++k)
    CHECK(now[k] == (k < 3 ? before[k] + displacement[int(k)] : 0));
  CHECK(before.back() != 0);
  const std::vector<double> plane = numbers(state, "walls/1/state");
  CHECK(numbers(moving.state(), "walls/1/state").back() != 0);
  CHECK(plane.back() == 0);
}
