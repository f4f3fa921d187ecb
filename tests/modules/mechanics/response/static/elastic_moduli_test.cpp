#include "packings.hpp"

#include <cmath>

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include <scree/response/elastic_moduli.hpp>

using namespace scree;
using namespace scree::response;

namespace {

constexpr double normal_stiffness = 1000, tangential_stiffness = 600;
constexpr int layers = 5;

// Spheres of radius 1 on a cubic lattice between walls, periodic along x and z; their distance is smaller
// than 2 by `overlap`, that to the walls by half of it.
Scene cube(double overlap, int upper_control = -1) {
  const double d = 2 - overlap;
  std::vector<Body> bodies;
  for (int n = 0; n < 9 * layers; ++n)
    bodies.push_back(test::body(n, 1, 1, {{d * (n % 3), d * (n / 9 + 0.5), d * (n / 3 % 3)}}));
  Scene scene = test::scene(3, 1e-4, std::move(bodies),
                            {{"normal_stiffness", {normal_stiffness}},
                             {"normal_damping", {0}},
                             {"tangential_stiffness", {tangential_stiffness}},
                             {"static_friction", {50}}});
  test::add_boundary(scene, "periodic",
                     {{"axes", {4}}, {"lower", {-0.5, -1, -0.5}}, {"upper", {3 * d - 0.5, 99, 3 * d - 0.5}}});
  test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}}, "bottom");
  test::Values top = {{"point", {0, d * layers, 0}}, {"normal", {0, -1, 0}}};
  if (upper_control >= 0)
    top.insert(top.end(), {{"direction", {0, -1, 0}},
                           {"control", {double(upper_control)}},
                           {"force", {0, 1}},
                           {"speed_limit", {1}}});
  test::add_boundary(scene, "plane", top, "top");
  return scene;
}

// G of a column: displacements x_i and rotations θ_i of its spheres, springs k_t at the contacts with the
// neighbours above and below (or a wall), and at those beside, where only θ_i counts.
double shear_modulus_of_column(double d) {
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(2 * layers + 2, 2 * layers + 2);
  const int top = 2 * layers + 1;  // displacement of the upper wall; that of the lower one is 2 layers
  const auto add = [&](const Eigen::VectorXd& slip) { k += tangential_stiffness * slip * slip.transpose(); };
  for (int i = 0; i <= layers; ++i) {
    Eigen::VectorXd slip = Eigen::VectorXd::Zero(k.rows());
    slip[i == 0 ? 2 * layers : 2 * (i - 1)] += 1;
    slip[i == layers ? top : 2 * i] -= 1;
    if (i > 0) slip[2 * (i - 1) + 1] += 0.5 * d;
    if (i < layers) slip[2 * i + 1] += 0.5 * d;
    add(slip);
  }
  for (int i = 0; i < layers; ++i) add(d * Eigen::VectorXd::Unit(k.rows(), 2 * i + 1));
  const Eigen::Index n = 2 * layers;
  const Eigen::VectorXd moved = -k.topLeftCorner(n, n).partialPivLu().solve(k.col(top).head(n));
  const double force = k(top, top) + k.row(top).head(n).dot(moved);
  return force / (d * d) * (layers * d);
}

}  // namespace

// Springs in line: N + 1 of them over N layers. M = k/(N + 1) L/d², K_0 = 0.
TEST_CASE("a cubic lattice has the moduli of its springs", "[response]") {
  // Without stress; an overlap of 1e-12 is a contact.
  const double overlap = 1e-12, d = 2 - overlap;
  const ElasticModuli moduli = elastic_moduli(Simulation(cube(overlap)));
  CHECK(moduli.walls.axis == 1);
  CHECK(moduli.walls.distance == Approx(layers * d));
  CHECK(moduli.walls.area == Approx(9 * d * d));
  const double m = normal_stiffness / (layers + 1) * layers / d;
  // 1e-10: the stress that is left.
  CHECK(std::abs(moduli.compression.modulus / m - 1) < 1e-10);
  CHECK(std::abs(moduli.compression.middle_modulus / (normal_stiffness / d) - 1) < 1e-10);
  CHECK(std::abs(moduli.compression.virial[1] / m - 1) < 1e-10);
  CHECK(std::abs(moduli.lateral_ratio()) < 1e-10);
  REQUIRE(moduli.shear.size() == 2);
  for (const StrainResponse& shear : moduli.shear) {
    CHECK(std::abs(shear.modulus / shear_modulus_of_column(d) - 1) < 1e-10);
    CHECK(shear.balance < 1e-10);
  }
  // Far from the walls half the slip is rotation: G = k_t/(2 d).
  CHECK(moduli.shear[0].middle_modulus == Approx(tangential_stiffness / (2 * d)).epsilon(0.05));
}

TEST_CASE("in a disordered packing under stress walls and contacts tell the same normal stress",
          "[response]") {
  Scene scene = cube(0.02);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    for (int k = 0; k < 3; ++k)
      scene.bodies[i].position[k] += 4e-3 * std::sin(1.0 + 2.3 * double(i) + 1.7 * k);
  scene.step = 2e-3;
  test::add_body_force(scene, "background_damping", {{"translational", {20}}, {"rotational", {20}}});
  // To rest: the mean of the stress over the volume is that on the walls only in equilibrium.
  Simulation packing(scene);
  test::run(packing, 20000);
  const ElasticModuli moduli = elastic_moduli(packing);
  // Round-off of forces, in the solution by way of its condition, 1e3.
  CHECK(moduli.compression.balance < 1e-10);
  CHECK(std::abs(moduli.compression.virial[1] / moduli.compression.modulus - 1) < 1e-10);
  CHECK(moduli.shear[0].balance < 1e-10);
  CHECK(moduli.shear[0].residual < 1e-12);
  CHECK(std::abs(moduli.lateral_ratio()) > 1e-5);
}

TEST_CASE("walls that forces move are held while elastic constants are measured", "[response]") {
  const auto modulus = [](int control) {
    return elastic_moduli(Simulation(cube(0.02, control))).compression.modulus;
  };
  CHECK(modulus(6) == Approx(modulus(-1)).epsilon(1e-10));  // massless
}

TEST_CASE("elastic constants of isotropic moduli", "[response]") {
  // λ = 2, μ = 3: M = 8, E = μ(3λ + 2μ)/(λ + μ) = 7.2, ν = λ/(2(λ + μ)) = 0.2; K_0 = λ/M
  ElasticModuli solid = {{}, {1, 8, 8, {2, 8, 2}, 0, 0}, {{0, 3, 3, {}, 0, 0}, {2, 3, 3, {}, 0, 0}}, 0};
  CHECK(solid.youngs_modulus() == Approx(7.2));
  CHECK(solid.poissons_ratio() == Approx(0.2));
  CHECK(solid.poissons_ratio_by_lateral_ratio() == Approx(0.2));
  // In a plane: E = 4μ(λ + μ)/(λ + 2μ) = 7.5, ν = λ/(λ + 2μ) = 0.25
  solid.shear.pop_back();
  CHECK(solid.youngs_modulus() == Approx(7.5));
  CHECK(solid.poissons_ratio() == Approx(0.25));
  CHECK(solid.poissons_ratio_by_lateral_ratio() == Approx(0.25));
}

TEST_CASE("elastic constants need two walls in a packing that is periodic otherwise", "[response]") {
  const Simulation heap(
      test::heap(3, {{"normal_stiffness", {1000}}, {"normal_damping", {0}}}, "linear_spring_dashpot", 1));
  CHECK_THROWS_WITH(
      elastic_moduli(heap),
      "elastic constants need two parallel walls across an axis and periodic boundaries along the other two; here are 1 "
      "wall and the periodic axes none; leave --elastic out, or prepare such a packing");
}

TEST_CASE("elastic constants are not those of a packing in which bodies are fixed", "[response]") {
  Scene scene = cube(1e-3);
  scene.bodies[0].fixed = true;
  CHECK_THROWS_WITH(wall_pair(Simulation(scene)),
                    Catch::Contains("here 1 body is fixed too, which bears load; leave --elastic out"));
}
