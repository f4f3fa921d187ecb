#include "meshes.hpp"
#include "packings.hpp"

#include <catch2/catch.hpp>

#include <scree/response/linear_system.hpp>

// A bead that lies on a plate and leans on the upper edge of a fin, a little less deep.

using namespace scree;

namespace {

Scene bead_on_plate_and_fin() {
  test::Mesh mesh;
  const double edge = 0.94 - std::sqrt(0.97 * 0.97 - 0.9 * 0.9);  // 0.97 from the centre
  mesh.points = {{{-3, -3, 0}},     {{3, -3, 0}},     {{3, 3, 0}},      {{-3, 3, 0}},
                 {{0.9, -2, 0.05}}, {{0.9, 2, 0.05}}, {{0.9, 2, edge}}, {{0.9, -2, edge}}};
  mesh.add({0, 1, 2, 3});
  mesh.add({4, 5, 6, 7});
  Scene scene = test::scene(3, 1e-3, {test::body(0, 1, test::heavy, {{0, 0.1, 0.94}})},
                            {{"normal_stiffness", {1000}},
                             {"normal_damping", {0}},
                             {"tangential_stiffness", {600}},
                             {"static_friction", {50}}},
                            "sphere_path_independent");
  test::add_boundary(scene, "mesh", {{"file", mesh.numbers()}});
  return scene;
}

}  // namespace

// The tolerance is that of assemble_test.cpp: differences of fourth order.
TEST_CASE("each spot of a mesh has the stiffness of its own place", "[response][surfaces]") {
  const Scene scene = bead_on_plate_and_fin();
  const State state = test::strained(scene);
  const Simulation simulation(scene, state);
  REQUIRE(simulation.contact_list().size() == 2);
  const response::LinearSystem system = response::assemble(simulation, {.fewest_contacts = 1});
  const test::Matrix expected = test::stiffness_by_differences(scene, state, system.freedom);
  CHECK((test::Matrix(system.stiffness) - expected).cwiseAbs().maxCoeff() <
        1e-8 * expected.cwiseAbs().maxCoeff());
}
