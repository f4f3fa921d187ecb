#include "scenes.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using scree::ContactList;
using scree::Scene;
using scree::Simulation;

TEST_CASE("storing per-contact forces changes nothing else") {
  Scene scene = scree::test::scene(
      3, 1e-4,
      {scree::test::body(1, 0.5, 1, {}, {}), scree::test::body(2, 0.5, 1, {{0.99, 0, 0}}, {{0, 0.1, 0}})},
      {{"normal_stiffness", {1e3}}, {"normal_damping", {0}}});
  Simulation with(scene);
  scene.pair_forces = false;
  Simulation without(scene);
  for (int k = 0; k < 10; ++k) with.step(), without.step();
  CHECK(with.state_hash() == without.state_hash());
  CHECK(with.footprint().bytes_per_pair == without.footprint().bytes_per_pair + 3 * sizeof(double));
  const ContactList kept = with.contact_list(), left_out = without.contact_list();
  REQUIRE(kept.size() == 1);
  CHECK(kept.force[0] == with.particles().force()[0][kept.a[0]]);
  REQUIRE(left_out.size() == 1);
  CHECK(std::isnan(left_out.force[0]));
}
