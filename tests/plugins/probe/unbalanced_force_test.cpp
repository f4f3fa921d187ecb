#include "probe_support.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include <scree/probes.hpp>

using namespace scree;
using namespace scree::test;

namespace {

const Values stiff_law = {{"normal_stiffness", {1e4}}, {"normal_damping", {0}}};

}  // namespace

TEST_CASE("unbalanced_force: three discs in a row, of which the outer ones are pushed out", "[probe]") {
  // Overlaps of 0.01 and 0.02: forces of 100 and 200 N; net forces 100, 100 and 200 N.
  const Simulation s(scene(2, 1e-4,
                           {body(1, 1, 1, {{0, 0, 0}}, {}, {}, 2), body(2, 1, 1, {{1.99, 0, 0}}, {}, {}, 2),
                            body(3, 1, 1, {{3.97, 0, 0}}, {}, {}, 2)},
                           stiff_law));
  const Sampled row = sample(s, "unbalanced_force");
  CHECK(row["mean_contact_force"] == Approx(150));
  CHECK(row["mean"] == Approx(400.0 / 3 / 150));
  CHECK(row["largest"] == Approx(200.0 / 150));
}

TEST_CASE("unbalanced_force: a disc that rests on the ground is in balance", "[probe]") {
  Scene sc = scene(2, 1e-4, {body(1, 1, 2, {{0, 1 - 2 * 10 / 1e4, 0}}, {}, {}, 2)}, stiff_law);
  add_boundary(sc, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}}, "ground");
  add_body_force(sc, "gravity", {{"acceleration", {0, -10, 0}}});
  const Sampled row = sample(Simulation(sc), "unbalanced_force");
  CHECK(row["mean_contact_force"] == Approx(20));
  CHECK(row["largest"] < 1e-10);  // round-off of the overlap, 1e-16 of 1 m times 1e4 N/m, over 20 N
}

TEST_CASE("unbalanced_force: fixed discs, which bear a load, do not count", "[probe]") {
  // Overlaps of 0.01 and 0.02: the disc in the middle has a net force of 100 N.
  Scene sc = scene(2, 1e-4,
                   {body(1, 1, 1, {{0, 0, 0}}, {}, {}, 2), body(2, 1, 1, {{1.99, 0, 0}}, {}, {}, 2),
                    body(3, 1, 1, {{3.97, 0, 0}}, {}, {}, 2)},
                   stiff_law);
  sc.bodies[0].fixed = sc.bodies[2].fixed = true;
  const Sampled row = sample(Simulation(sc), "unbalanced_force");
  CHECK(row["mean_contact_force"] == Approx(150));
  CHECK(row["mean"] == Approx(100.0 / 150));
  CHECK(row["largest"] == Approx(100.0 / 150));
}

TEST_CASE("unbalanced_force: without contacts there is no value", "[probe]") {
  const Simulation s(scene(2, 1e-4, {body(1, 1, 1, {{0, 0, 0}}, {}, {}, 2)}, stiff_law));
  CHECK(std::isnan(sample(s, "unbalanced_force")["mean"]));
}

TEST_CASE("unbalanced_force: along axes in which a disc is held there is no force to count", "[probe]") {
  // Overlaps of 0.01 and 0.02, at right angles: the disc in the corner has net forces of 100 and 200 N.
  Scene sc = scene(2, 1e-4,
                   {body(1, 1, 1, {{0, 0, 0}}, {}, {}, 2), body(2, 1, 1, {{1.99, 0, 0}}, {}, {}, 2),
                    body(3, 1, 1, {{0, 1.98, 0}}, {}, {}, 2)},
                   stiff_law);
  CHECK(sample(Simulation(sc), "unbalanced_force")["largest"] == Approx(std::hypot(100, 200) / 150));
  sc.bodies[0].held = 1u << 1;
  CHECK(sample(Simulation(sc), "unbalanced_force")["mean"] == Approx((100 + 100 + 200) / 3.0 / 150));
  sc.bodies[0].held = 1u << 0;
  CHECK(sample(Simulation(sc), "unbalanced_force")["mean"] == Approx((200 + 100 + 200) / 3.0 / 150));
}

TEST_CASE("unbalanced_force: of discs that a scenario chooses, and their contacts", "[probe]") {
  // Overlaps of 0.01, 0.02 and 0.04 in a row: net forces of 100, 100, 200 and 400 N.
  const Simulation s(
      scene(2, 1e-4,
            {body(1, 1, 1, {{0, 0, 0}}, {}, {}, 2), body(2, 1, 1, {{1.99, 0, 0}}, {}, {}, 2),
             body(3, 1, 1, {{3.97, 0, 0}}, {}, {}, 2), body(4, 1, 1, {{5.93, 0, 0}}, {}, {}, 2)},
            stiff_law));
  const Sampled last_two = sample(s, "unbalanced_force", {}, {1, 1, 0, 0});
  CHECK(last_two["mean_contact_force"] == Approx(300));
  CHECK(last_two["mean"] == Approx(1));
  CHECK(last_two["largest"] == Approx(400.0 / 300));
}
