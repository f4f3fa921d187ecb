#include "surfaces/sliding_work.hpp"

#include "meshes.hpp"
#include "scenes.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/energy.hpp>
#include <scree/error.hpp>
#include <scree/state.hpp>
#include <scree/state_transfer.hpp>

// What friction dissipates on the facets of surfaces.

using namespace scree;
using namespace scree::test;

namespace {

const Values rubbing = {{"normal_stiffness", {2000}},
                        {"restitution", {0.6}},
                        {"tangential_stiffness", {800}},
                        {"static_friction", {0.3}}};

// Spheres, which touch each other without friction, slide in a turning drum and on its floor, a mesh.
Scene spheres_in_a_drum(Integration integration) {
  std::vector<Body> bodies;
  for (int k = 0; k < 6; ++k) {
    const double turn = 1.0 * k;
    bodies.push_back(
        body(k, 0.05, 1, {{0.4 * std::cos(turn), 0.4 * std::sin(turn), 0.0499}}, {{0.3, 0.1 * k, 0}}));
  }
  Scene s = scene(3, 1e-3, bodies, rubbing);
  s.integration = integration;
  s.sliding_work = true;
  add_boundary(s, "cylinder",
               {{"point", {0, 0, -0.1}},
                {"axis", {0, 0, 1}},
                {"radius", {0.45}},
                {"length", {1}},
                {"side", {2}},
                {"spin", {1.5}}},
               "mantle");
  add_boundary(s, "mesh", {{"file", flat_mesh(0.6, 6, 6).numbers()}}, "floor");
  s.materials = {"grain", "wall"};
  s.laws.push_back({"smooth", parameters("linear_spring_dashpot", SCREE_CONTACT_LAW,
                                         {{"normal_stiffness", {2000}}, {"restitution", {0.6}}})});
  s.law_of = {1, 0, 0, 0};
  for (Scene::Boundary& boundary : s.boundaries) boundary.material = 1;
  add_body_force(s, "gravity", {{"acceleration", {0, 0, -9}}});
  return s;
}

double sum_on(const Simulation& s, std::size_t surface) {
  double sum = 0;
  for (const double work : s.sliding_work(surface)) sum += work;
  return sum;
}

}  // namespace

TEST_CASE("sliding work on surfaces is what friction dissipates where walls alone have friction",
          "[surfaces]") {
  for (const Integration integration : {Integration::velocity_verlet, Integration::position_verlet,
                                        Integration::predictor_corrector, Integration::fourth_order}) {
    Simulation s(spheres_in_a_drum(integration));
    run(s, 1500);
    const double on_mantle = sum_on(s, 0), on_floor = sum_on(s, 1);
    CHECK(on_mantle > 1e-3);
    CHECK(on_floor > 1e-3);
    // Round-off of sums of some thousand terms.
    CHECK(on_mantle + on_floor == Approx(s.energy().dissipated_friction).epsilon(1e-12));
    for (std::size_t surface = 0; surface < 2; ++surface)
      for (const double work : s.sliding_work(surface)) CHECK(work >= 0);
  }
}

TEST_CASE("a body that is pushed along a floor leaves its work on its path", "[surfaces]") {
  // It cannot turn: it slides from x = 0.1 to where it has lost its energy, over v²/(2 μ g) = 0.1699 m.
  Body sledge = body(1, 0.05, 1, {{0.1, 0.03, 0.05 - 9.81 / 1e5}}, {{1, 0, 0}});
  sledge.held = freedom::rotations;
  Scene sc = scene(3, 1e-4, {sledge},
                   {{"normal_stiffness", {1e5}},
                    {"normal_damping", {0}},
                    {"tangential_stiffness", {5e4}},
                    {"static_friction", {0.3}}});
  sc.sliding_work = true;
  add_boundary(sc, "rectangle",
               {{"point", {0, 0, 0}},
                {"normal", {0, 0, 1}},
                {"along", {1, 0, 0}},
                {"length", {0.48}},
                {"width", {0.48}}});
  add_body_force(sc, "gravity", {{"acceleration", {0, 0, -9.81}}});
  Simulation s(sc);
  run(s, 4000);
  const std::vector<double> work = s.sliding_work(0);
  REQUIRE(work.size() == 24 * 24);  // cells of 20 mm
  double all = 0;
  for (std::size_t k = 0; k < work.size(); ++k) {
    all += work[k];
    const auto column = k % 24, row = k / 24;
    // x from 0.1 m, behind the 17th column, to 0.24 m, the edge, where it would fall: it stops before.
    if (work[k] > 0) CHECK((row == 13 && column >= 17));
  }
  // Within a cell the force is μ m g; at each of its ends the work of a step may belong to either cell.
  CHECK(work[13 * 24 + 19] == Approx(0.3 * 9.81 * 0.02).margin(2 * 0.3 * 9.81 * 1e-4));
  CHECK(all == Approx(s.energy().dissipated_friction).epsilon(1e-12));
}

TEST_CASE("a run that goes on from its state keeps sliding work to the bit", "[surfaces]") {
  const Scene sc = spheres_in_a_drum(Integration::velocity_verlet);
  Simulation whole(sc), first(sc);
  run(whole, 600);
  run(first, 300);
  Simulation second(sc, first.state());
  run(second, 300);
  for (std::size_t surface = 0; surface < 2; ++surface)
    CHECK(second.sliding_work(surface) == whole.sliding_work(surface));
  // A scene that begins from the state has done no work.
  Simulation branch(sc, first.state(), Branching{});
  CHECK(sum_on(branch, 0) == 0);
}

TEST_CASE("sliding work is added up exactly, and needs facets", "[surfaces]") {
  WallSurfaces surfaces;
  surfaces.shapes = {{SCREE_FLAT, SCREE_BOTH_SIDES, {1}, nullptr, 0}};
  surfaces.meshes = {nullptr};
  surfaces.names = {"floor"};
  SlidingWork work(surfaces, 2);
  work.add({0, 5, 1e6});
  for (int k = 0; k < 1000; ++k) work.add({0, 5, 1e-15}), work.add({0, 7, -0.25});
  work.add({0, 5, -1e6});
  CHECK(work.of(0)[5] == Approx(1e-12).epsilon(1e-12));  // each term is rounded to 2^-100 J
  CHECK(work.of(0)[7] == -250);
  State state;
  work.transfer(StateTransfer::saving_to(state));
  SlidingWork restored(surfaces, 2);
  restored.transfer(StateTransfer::restoring_from(state));
  CHECK(restored.of(0) == work.of(0));
  Scene sc = scene(3, 1e-3, {body(1, 0.1, 1, {{0, 0, 0}})}, rubbing);
  sc.sliding_work = true;
  add_boundary(sc, "cylinder", {{"point", {0, 0, 0}}, {"axis", {0, 0, 1}}, {"radius", {9}}}, "pipe");
  CHECK_THROWS_WITH(Simulation(sc), Catch::Contains("surface pipe is infinite"));
}
