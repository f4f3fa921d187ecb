#include "scenes.hpp"

#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include <scree/simulation.hpp>
#include <scree/state.hpp>

// Laws that follow surfaces and paths in some stages alone.

using namespace scree;
using namespace scree::test;

namespace {

const std::string law = "sphere_path_independent";

Values with_friction(double friction) {
  return {{"normal_stiffness", {1000}},
          {"restitution", {0.5}},
          {"tangential_stiffness", {700}},
          {"static_friction", {friction}}};
}

// Beads that slide on the floor of a cylinder, to its wall and along it.
Scene beads_in_cylinder(double friction) {
  std::vector<Body> beads;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y) {
      Body bead = body(5 * x + y + 13, 0.004, 6.7e-4, {{0.0085 * x, 0.0085 * y, 0.004}}, {{0.3, 0.1 * y, 0}});
      bead.spin = {{10.0 * y, 0, 20.0 * x}};
      beads.push_back(bead);
    }
  Scene s = scene(3, 2e-5, beads, with_friction(friction), law);
  add_boundary(s, "cylinder", {{"point", {0, 0, 0}}, {"axis", {0, 0, 1}}, {"radius", {0.03}}}, "mantle");
  add_boundary(s, "disc", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}, {"radius", {0.03}}}, "floor");
  add_body_force(s, "gravity", {{"acceleration", {0, 0, -9.81}}});
  s.spin = s.orientations = true;  // some stages need them
  return s;
}

void set_friction(Simulation& s, double friction) {
  s.reconfigure_law(law, parameters(law, SCREE_CONTACT_LAW, with_friction(friction)));
  s.apply_reconfiguration();
}

}  // namespace

// A simulation that began with the law of the stage has no numbers of earlier ones.
TEST_CASE("stages may switch friction at surfaces off and on, to the bits of a run that begins there",
          "[surfaces]") {
  Simulation s(beads_in_cylinder(0.3));
  std::size_t most_rows = 0;
  for (const double friction : {0.0, 0.3, 0.0}) {
    run(s, 2500);
    most_rows = std::max(most_rows, s.contact_list().size());
    set_friction(s, friction);
    Simulation anew(s.scene(), s.state());
    run(s, 2500), run(anew, 2500);
    CHECK(s.state_hash() == anew.state_hash());
  }
  CHECK(most_rows > 25);
  // Of second order in the step, 13 of which are in a contact.
  CHECK(std::abs(s.energy_residual()) < 1e-2);
}
