#include "assembly/pair_at_rest.hpp"

#include "scenes.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::response;

// Radii 1 and 0.6 with an overlap of 0.1, and the first on a floor with one of 0.05.
TEST_CASE("a pair has the levers and inputs of its radii and masses", "[response]") {
  Scene scene =
      test::scene(3, 1e-4, {test::body(0, 1, 2, {{0, 0.95, 0}}), test::body(1, 0.6, 3, {{1.5, 0.95, 0}})},
                  {{"normal_stiffness", {1000}}, {"normal_damping", {0}}});
  test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}});
  const Simulation simulation(scene);
  const Particles& p = simulation.particles();
  PairAtRest pair(p, 0, 1), wall(p, 0, 2);
  pair.set_between_bodies({{-1.5, 0, 0}});
  wall.distance = 0.95, wall.normal = {{0, 1, 0}}, wall.separation = {{0, 0.95, 0}};
  CHECK_FALSE(pair.to_wall());
  CHECK(wall.to_wall());
  CHECK(pair.overlap() == Approx(0.1));
  CHECK(wall.overlap() == Approx(0.05));
  // To the middle of the overlap, or to the surfaces.
  CHECK(pair.lever_arms(SCREE_ARM_CONTACT_POINT).a == Approx(0.95));
  CHECK(pair.lever_arms(SCREE_ARM_CONTACT_POINT).b == Approx(0.55));
  CHECK(pair.lever_arms(SCREE_ARM_RADIUS).a == Approx(1));
  CHECK(pair.lever_arms(SCREE_ARM_RADIUS).b == Approx(0.6));
  CHECK(wall.lever_arms(SCREE_ARM_CONTACT_POINT).a == Approx(0.975));
  CHECK(wall.lever_arms(SCREE_ARM_CONTACT_POINT).b == 0);
  CHECK(pair.distance == 1.5);
  CHECK(pair.geometry(3, 3, SCREE_ARM_RADIUS).normal_change(1, 1) == Approx(1 / 1.5));
  CHECK(pair.geometry(3, 3, SCREE_ARM_RADIUS).normal_change(0, 0) == 0);
  CHECK(wall.geometry(3, 3, SCREE_ARM_RADIUS).normal_change.isZero(0));

  ContactColumns columns(2);
  pair.set_inputs(p, p.orientations, 0, columns, 0);
  wall.set_inputs(p, p.orientations, 0, columns, 1);
  CHECK(columns.input(SCREE_OVERLAP, 0, 0) == Approx(0.1));
  CHECK(columns.input(SCREE_REDUCED_MASS, 0, 0) == Approx(1.2));  // 2 3/5
  CHECK(columns.input(SCREE_REDUCED_MASS, 0, 1) == Approx(2));
  CHECK(columns.input(SCREE_EFFECTIVE_RADIUS, 0, 0) == Approx(0.375));  // 1 0.6/1.6
  CHECK(columns.input(SCREE_EFFECTIVE_RADIUS, 0, 1) == Approx(1));
  CHECK(columns.input(SCREE_NORMAL, 0, 0) == -1);
  CHECK(columns.input(SCREE_SEPARATION, 1, 1) == 0.95);
  CHECK(columns.input(SCREE_RADII, 1, 0) == 0.6);
  CHECK(columns.input(SCREE_RADII, 1, 1) == 0);
}
