#include "meshes.hpp"
#include "over_ranks.hpp"
#include "sanitized.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/simulation.hpp>
#include <scree/wall_surfaces.hpp>

// Walls that are no planes, over threads and ranks.

using namespace scree;
using namespace scree::test;

namespace {

constexpr double hollow = 8.12, lid = 20;  // the outermost spheres touch each of them from the start
constexpr int steps_of_drum = sanitized ? 30 : 150;

// Spheres that fill a turning drum with two end plates, one of which turns alone; of several tiles. The
// mantle is a cylinder or a mesh with its lower plate, whose edge is touched twice.
Scene drum_of_spheres(bool mesh, const std::string& law) {
  std::vector<Body> bodies;
  for (int x = -7; x <= 7; ++x)
    for (int y = -7; y <= 7; ++y)
      for (int z = 0; z < 20; ++z) {
        const Vec3 place = {{1.0 * x, 1.0 * y, 1.0 * z + 0.5}};
        if (place[0] * place[0] + place[1] * place[1] > 58) continue;
        if (y == 0 && z == 10 && x * x <= 1) continue;  // where the blade is
        const auto number = std::int64_t(bodies.size());
        bodies.push_back(body(number, 0.5 + 0.01 * double(number % 3), 1, place,
                              {{0.3 * double(number % 5) - 0.6, 0.2, 0.1 * double(number % 7)}}));
      }
  Scene s = scene(3, 2e-3, bodies,
                  {{"normal_stiffness", {2000}},
                   {"restitution", {0.6}},
                   {"tangential_stiffness", {800}},
                   {"static_friction", {0.4}}},
                  law);
  if (mesh) {
    Mesh pot = cylinder_mesh(hollow, 10.5, 90, 12);
    pot.points.push_back({{0, 0, -10.5}});
    for (std::size_t i = 0; i < 90; ++i) pot.add(i, (i + 1) % 90, pot.points.size() - 1);
    add_boundary(
        s, "mesh",
        {{"file", pot.numbers()}, {"translation", {0, 0, 10.5}}, {"spin", {0.5}}, {"spin_axis", {0, 0, 1}}},
        "pot");
  } else {
    add_boundary(s, "cylinder",
                 {{"point", {0, 0, 0}},
                  {"axis", {0, 0, 1}},
                  {"radius", {hollow}},
                  {"length", {4 * lid}},
                  {"side", {2}},
                  {"spin", {0.5}}},
                 "mantle");
    add_boundary(s, "disc",
                 {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"radius", {hollow}}, {"spin", {0.5}}}, "low");
  }
  add_boundary(s, "disc",
               {{"point", {0, 0, lid}}, {"normal", {0, 0, -1}}, {"radius", {hollow}}, {"spin", {-2}}},
               "high");
  add_boundary(s, "rectangle",
               {{"point", {0, 0, lid / 2}},
                {"normal", {0, 1, 0}},
                {"along", {1, 0, 0}},
                {"length", {1.5}},
                {"width", {0.5}},
                {"spin", {0.5}},
                {"spin_axis", {0, 0, 1}}},
               "blade");
  add_body_force(s, "gravity", {{"acceleration", {0, -3, -1}}});
  s.min_bodies_per_thread = 1;
  return s;
}

struct TurnedDrum {
  std::uint64_t hash;
  std::vector<double> loads, sliding_work;

  bool operator==(const TurnedDrum&) const = default;
};

TurnedDrum turned_drum(bool mesh, const std::string& law, unsigned threads, Ranks* ranks) {
  Scene scene = drum_of_spheres(mesh, law);
  scene.threads = threads;
  scene.sliding_work = true;
  Simulation s(scene, ranks);
  s.run(steps_of_drum / 2, [] { return true; });
  s.sliding_work(0);  // which the first rank then has of all
  s.run(steps_of_drum - steps_of_drum / 2, [] { return true; });
  TurnedDrum outcome = {s.state_hash(), {}, {}};
  for (std::size_t surface = 0; surface < s.surfaces().size(); ++surface)
    for (const double work : s.sliding_work(surface)) outcome.sliding_work.push_back(work);
  for (const scree_frame_load& load : s.surfaces().loads)
    for (int k = 0; k < 3; ++k) outcome.loads.insert(outcome.loads.end(), {load.force[k], load.torque[k]});
  return outcome;
}

}  // namespace

TEST_CASE("surfaces that turn give the same bits on any number of threads and ranks", "[ranks]") {
  for (const auto& [mesh, law] : {std::pair<bool, std::string>{false, "linear_spring_dashpot"},
                                  {true, "linear_spring_dashpot"},
                                  {true, "sphere_path_independent"}}) {
    REQUIRE(drum_of_spheres(mesh, law).bodies.size() >= 3 * 1024);
    const TurnedDrum expected = turned_drum(mesh, law, 1, nullptr);
    REQUIRE(expected.loads.size() == (mesh ? 3 : 4) * 6);
    for (std::size_t surface = 0; surface < (mesh ? 2 : 3); ++surface)
      CHECK(expected.loads[6 * surface + 5] != 0);
    CHECK(std::count_if(expected.sliding_work.begin(), expected.sliding_work.end(),
                        [](double w) { return w > 0; }) > 100);
    CHECK(turned_drum(mesh, law, 3, nullptr) == expected);
    for (const bool at_random : {false, true})
      for (const unsigned count : {2u, 3u})
        over_ranks(count, at_random, [&, mesh = mesh, law = law](Ranks& ranks) {
          INFO(count << " ranks, tiles at random " << at_random << ", mesh " << mesh << ", " << law);
          CHECK(turned_drum(mesh, law, 1, &ranks) == expected);
        });
  }
}
