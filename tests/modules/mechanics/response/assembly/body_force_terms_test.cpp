#include "assembly/body_force_terms.hpp"

#include "scenes.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::response;

namespace {

Scene two_spheres() {
  return test::scene(3, 1e-4, {test::body(0, 1, 2, {}), test::body(1, 0.5, 3, {{5, 0, 0}}, {{1, 2, 3}})},
                     {{"normal_stiffness", {1000}}, {"normal_damping", {0}}});
}

}  // namespace

TEST_CASE("gravity is a load without stiffness, and drag a damping without load", "[response]") {
  Scene scene = two_spheres();
  test::add_body_force(scene, "gravity", {{"acceleration", {0, -10, 1}}});
  test::add_body_force(scene, "background_damping", {{"translational", {0.7}}, {"rotational", {0.4}}});
  const std::vector<BodyForceTerms> terms = linearise_body_forces(Simulation(scene), 3);
  REQUIRE(terms.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    const double mass = scene.bodies[i].mass, turning = 0.4 * std::pow(scene.bodies[i].radius, 2);
    Eigen::VectorXd drag(6);
    drag << 0.7, 0.7, 0.7, turning, turning, turning;
    Eigen::VectorXd load(6);
    load << 0, -10 * mass, mass, 0, 0, 0;
    CHECK((terms[i].load - load).norm() < 1e-13);
    CHECK(terms[i].stiffness.norm() < 1e-9);  // round-off of 30 N over 1e-4 radii
    CHECK((Eigen::MatrixXd(terms[i].damping) - Eigen::MatrixXd(drag.asDiagonal())).norm() < 1e-9);
  }
}

TEST_CASE("a scene without body forces has no terms", "[response]") {
  CHECK(linearise_body_forces(Simulation(two_spheres()), 3).empty());
}
