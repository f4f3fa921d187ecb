#include "packings.hpp"

#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include <scree/response/linear_system.hpp>

using namespace scree;
using namespace scree::response;
using scree::test::Matrix;
using scree::test::Values;

namespace {

constexpr const char* wall_names[] = {"x_low", "x_high", "y_low", "y_high", "z_low", "z_high"};
enum { box_stress, box_fixed };

// Stresses of about a tenth of the stiffness of a contact over its radius, different along each axis.
Values box_of(int dimension) {
  return {{"lower", {-1.86, -1.85, -1.88}},
          {"upper", {1.87, 1.89, 1.86}},
          {"mass", {test::heavy}},
          {"stress_x", {0, 130}},
          {"stress_y", {0, 90}},
          {"stress_z", {0, dimension == 3 ? 110.0 : 0}}};
}

// Heavy bodies in a box of heavy walls under stress, all of them pressed together.
Scene boxed(int dimension, const Values& law, const std::string& plugin = "linear_spring_dashpot") {
  std::vector<Body> bodies;
  for (int n = 0; n < (1 << dimension); ++n) {
    Vec3 x = {};
    for (int k = 0; k < dimension; ++k) x[k] = ((n >> k & 1) ? 0.94 : -0.94) + 0.01 * std::sin(n + 2.0 * k);
    bodies.push_back(test::body(n, 1 + 0.01 * std::cos(2.0 * n), test::heavy, x, {}, {}, dimension));
  }
  Scene scene = test::scene(dimension, 1e-3, std::move(bodies), law, plugin);
  test::add_boundary(scene, "box", box_of(dimension));
  return scene;
}

// Forces on all degrees of freedom after wall w has moved inwards by a distance (m) in a step from the state.
Eigen::VectorXd loads_after(const Scene& scene, const State& state, const DegreesOfFreedom& freedom,
                            std::size_t w, double distance) {
  Simulation moved(scene, state);
  Values moving = box_of(scene.dimension);
  moving.push_back({std::string("superposed_") + wall_names[w], {3, 0, distance, scene.step}});
  moved.reconfigure_boundary("box", test::parameters("box", SCREE_BOUNDARY, moving));
  moved.apply_reconfiguration();
  moved.step();
  return test::loads(moved, freedom);
}

// Largest difference between K and the differences of the kernel's forces, over the largest entry of K.
double error_of_wall_stiffness(const Scene& scene) {
  const State state = test::strained(scene);
  const LinearSystem system = assemble(Simulation(scene, state), {.fewest_contacts = 1});
  REQUIRE(system.freedom.walls() == std::size_t(2 * scene.dimension));
  Matrix expected = test::stiffness_by_differences(scene, state, system.freedom);
  const double length = 2e-4;
  for (std::size_t w = 0; w < system.freedom.walls(); ++w) {
    const auto after = [&](double steps) {
      return loads_after(scene, state, system.freedom, w, steps * length);
    };
    expected.col(system.freedom.wall(w)) =
        -(8 * (after(1) - after(-1)) - (after(2) - after(-2))) / (12 * length);
  }
  return (Matrix(system.stiffness) - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

}  // namespace

// As in stiffness_test.cpp: differences of fourth order with steps of 2e-4 radii.
TEST_CASE("the stiffness of walls under stress is the derivative of loads and pressing forces",
          "[response]") {
  const Values smooth = {{"normal_stiffness", {1000}}, {"normal_damping", {0}}};
  const Values springs = {{"normal_stiffness", {1000}},
                          {"normal_damping", {0}},
                          {"tangential_stiffness", {600}},
                          {"static_friction", {50}}};
  for (const int dimension : {2, 3}) {
    CAPTURE(dimension);
    CHECK(error_of_wall_stiffness(boxed(dimension, smooth)) < 1e-8);
    CHECK(error_of_wall_stiffness(boxed(dimension, springs)) < 1e-8);
  }
  const Values hertz = {{"youngs_modulus", {1000}},
                        {"poissons_ratio", {0.25}},
                        {"restitution", {1}},
                        {"friction", {50}},
                        {"history", {2}}};  // potential
  CHECK(error_of_wall_stiffness(boxed(3, hertz, "hertz_mindlin")) < 1e-8);
}

TEST_CASE("the pressing force of a wall follows walls that are driven beside it", "[response]") {
  Scene scene = boxed(2, {{"normal_stiffness", {1000}}, {"normal_damping", {0}}});
  Values values = box_of(2);
  values.insert(values.end(), {{"y_low", {box_fixed}}, {"y_high", {box_fixed}}});
  scene.boundaries.clear();
  test::add_boundary(scene, "box", values);
  const LinearSystem system = assemble(Simulation(scene), {.fewest_contacts = 1});
  CHECK(system.freedom.wall(2) == DegreesOfFreedom::none);
  // A wall of length L_y has the force p L_y, and y_high moves outwards; no contact joins the two.
  CHECK(system.wall_stiffness.coeff(system.freedom.wall(0), 2 * 3 + 1) == Approx(-130));
  CHECK(system.wall_stiffness.coeff(system.freedom.wall(0), 2 * 2 + 1) == Approx(130));
  CHECK(system.stiffness.coeff(system.freedom.wall(0), system.freedom.wall(1)) == 0);
}
