#include "probe_support.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include <scree/probes.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// Three spheres in a row between fixed walls in x, each contact overlapping by 1e-4 m, and one that floats
// free.
Scene row_in_box() {
  const double r = 0.005, d = 1e-4;
  Scene sc =
      scene(3, 1e-6,
            {body(1, r, 1e-3, {{r - d, 0.02, 0.02}}), body(2, r, 1e-3, {{3 * r - 2 * d, 0.02, 0.02}}),
             body(3, r, 1e-3, {{5 * r - 3 * d, 0.02, 0.02}}), body(4, r, 1e-3, {{0.012, 0.033, 0.03}})},
            frictional_law);
  Values box = {{"lower", {0, 0, 0}}, {"upper", {6 * r - 4 * d, 0.04, 0.05}}};
  for (const char* wall : {"x_low", "x_high", "y_low", "y_high", "z_low", "z_high"})
    box.push_back({wall, {1}});
  add_boundary(sc, "box", box);
  return sc;
}

}  // namespace

TEST_CASE("box: lengths, stresses from forces over areas, solid fraction", "[probe]") {
  const Simulation s(row_in_box());
  const Sampled box = sample(s, "box");
  const double force = 5000 * 1e-4;
  CHECK(box["length_x"] == Approx(0.0296));
  CHECK(box["stress_xx"] == Approx(force / (0.04 * 0.05)));
  CHECK(box["stress_yy"] == 0);
  CHECK(box["deviatoric_stress"] == Approx(2.0 / 3.0 * force / (0.04 * 0.05)));
  CHECK(box["strain_xx"] == 0);
  CHECK(box["solid_fraction"] == Approx(4 * 4.0 / 3.0 * M_PI * std::pow(0.005, 3) / (0.0296 * 0.04 * 0.05)));
}

TEST_CASE("box: an absent wall is not in the mean, and bodies outside are not in the solid fraction",
          "[probe]") {
  Scene sc = row_in_box();
  // Overlaps of 1e-4 m at both ends of the row: the wall that is there bears as much as both did.
  sc.boundaries[0].parameters.set("x_low", {7});
  sc.bodies.push_back(body(5, 0.005, 1e-3, {{-0.02, 0.02, 0.02}}));
  const Sampled box = sample(Simulation(sc), "box");
  CHECK(box["stress_xx"] == Approx(5000 * 1e-4 / (0.04 * 0.05)));
  CHECK(box["solid_fraction"] == Approx(4 * 4.0 / 3.0 * M_PI * std::pow(0.005, 3) / (0.0296 * 0.04 * 0.05)));
}

TEST_CASE("contacts: bodies that are fixed do not count in means over bodies", "[probe]") {
  Scene sc = row_in_box();
  sc.bodies[0].fixed = true;
  const Sampled contacts = sample(Simulation(sc), "contacts");
  CHECK(contacts["contacts"] == 4);
  // Of the three others two have two contacts each.
  CHECK(contacts["coordination_number"] == Approx(4.0 / 3));
  CHECK(contacts["rattlers"] == 1);
  CHECK(contacts["coordination_without_rattlers"] == 2);
}

TEST_CASE("contacts: of bodies that a scenario chooses, with all their contacts", "[probe]") {
  const Simulation s(row_in_box());
  const Sampled last = sample(s, "contacts", {}, {1, 1, 0, 1});
  CHECK(last["contacts"] == 2);  // with the second body and the wall
  CHECK(last["coordination_number"] == 2);
  CHECK(last["rattlers"] == 0);
  CHECK(last["max_overlap"] == Approx(1e-4));
  const Sampled floating = sample(s, "contacts", {}, {1, 1, 1, 0});
  CHECK(floating["contacts"] == 0);
  CHECK(floating["rattlers"] == 1);
}

TEST_CASE("box: strain is relative to the first sample", "[probe]") {
  Scene sc = scene(3, 1e-3, {body(1, 0.01, 1, {{0.5, 0.5, 0.5}})}, frictional_law);
  add_boundary(sc, "box",
               {{"lower", {0, 0, 0}},
                {"upper", {1, 1, 1}},
                {"x_low", {1}},
                {"y_low", {1}},
                {"z_low", {1}},
                {"y_high", {1}},
                {"z_high", {1}},
                {"mass", {1}},
                {"stress", {0, 2}}});
  Simulation s(sc);
  Probe probe(parameters("box", SCREE_PROBE, {}), 3);
  probe.sample(SimulationView(s, false).get());
  run(s, 100);
  const Sampled box = {probe.names(), probe.sample(SimulationView(s, false).get())};
  // Uniform acceleration 2 m/s² for 0.1 s: 0.01 m of 1 m, exact in velocity Verlet.
  CHECK(box["strain_xx"] == Approx(0.01).epsilon(1e-10));
  CHECK(box["deviatoric_strain"] == Approx(0.01).epsilon(1e-10));
}

TEST_CASE("box: every axis must have opposite walls", "[probe]") {
  Scene sc = scene(3, 1e-3, {body(1, 0.01, 1, {{0, 0, 0.5}})}, frictional_law);
  add_boundary(sc, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
  const Simulation s(sc);
  CHECK_THROWS_WITH(sample(s, "box"), Catch::Contains("walls at both ends"));
}

TEST_CASE("contacts: coordination, overlaps, forces, rattlers", "[probe]") {
  const Simulation s(row_in_box());
  const Sampled c = sample(s, "contacts");
  CHECK(c["contacts"] == 4);  // two between bodies, two at walls
  CHECK(c["coordination_number"] == Approx(6.0 / 4));
  CHECK(c["coordination_without_rattlers"] == Approx(6.0 / 3));
  CHECK(c["rattlers"] == 1);
  CHECK(c["mean_overlap"] == Approx(1e-4));
  CHECK(c["max_overlap"] == Approx(1e-4));
  CHECK(c["mean_normal_force"] == Approx(0.5));
  CHECK(c["sliding_fraction"] == 0);
}

TEST_CASE("contacts: a body with one contact is a rattler and excluded with its contact", "[probe]") {
  Scene sc = row_in_box();
  sc.bodies[3].position = {{0.005 - 1e-4, 0.02, 0.0298}};  // touches body 1 from above
  const Simulation s(sc);
  const Sampled c = sample(s, "contacts");
  CHECK(c["contacts"] == 5 + 1);  // and the wall x_low
  CHECK(c["rattlers"] == 0);
  const Sampled strict = sample(s, "contacts", {{"rattler_below", {3}}});
  // Bodies have 3, 2, 2 and 2 contacts: three of four are rattlers, with 6 of 9 contact ends.
  CHECK(strict["rattlers"] == 3);
  CHECK(strict["coordination_without_rattlers"] == Approx(3.0));
}

TEST_CASE("contacts: a contact loaded beyond the Coulomb limit counts as sliding", "[probe]") {
  Scene sc =
      scene(3, 1e-5, {body(1, 0.005, 1e-3, {{0, 0, 0.0049}}, {{1, 0, 0}}, {{0, -1000, 0}})}, frictional_law);
  add_boundary(sc, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
  Simulation s(sc);
  run(s, 50);
  CHECK(sample(s, "contacts")["sliding_fraction"] == 1);
}

TEST_CASE("energy: the stored energies of a scene at rest and in motion", "[probe]") {
  Scene sc = row_in_box();
  sc.bodies[3].velocity = {{2, 0, 0}};
  sc.bodies[3].spin = {{0, 0, 100}};
  const Simulation s(sc);
  const Sampled e = sample(s, "energy");
  CHECK(e["elastic_normal"] == Approx(4 * 0.5 * 5000 * 1e-8));
  CHECK(e["kinetic_translation"] == Approx(0.5 * 1e-3 * 4));
  CHECK(e["kinetic_rotation"] == Approx(0.5 * 0.4 * 1e-3 * 25e-6 * 1e4));
  CHECK(e["work"] == 0);
  CHECK(e["residual"] == 0);
}

TEST_CASE("particles: columns of the selected ids, in 2D and 3D", "[probe]") {
  Scene sc = row_in_box();
  sc.bodies[3].spin = {{1, 2, 3}};
  const Simulation s(sc);
  const Sampled p = sample(s, "particles", {{"ids", {4, 1}}});
  CHECK(p.row.size() == 24);
  CHECK(p["y_4"] == 0.033);
  CHECK(p["spin_z_4"] == 3);
  CHECK(p["x_1"] == 0.0049);
  CHECK(p["fx_1"] == Approx(0).margin(1e-12));
  CHECK_THROWS_WITH(sample(s, "particles", {{"ids", {9}}}), Catch::Contains("does not exist"));
}
