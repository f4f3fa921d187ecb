#include "packings.hpp"

#include <algorithm>
#include <string>

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include <scree/response/linear_system.hpp>

// Beads at the bottom of hollows swing as pendulums whose length L is the distance of the centres.

using namespace scree;
using namespace scree::response;
using scree::test::Matrix;
using scree::test::Values;

namespace {

constexpr double hollow = 1, swinging_radius = 0.1, swinging_mass = 2, gravity = 9.81, hard_spring = 1e9;
constexpr double swinging_overlap = swinging_mass * gravity / hard_spring,
                 pendulum = hollow - swinging_radius + swinging_overlap;

LinearSystem bead_in(const std::string& plugin, Values hollow_values, const Values& friction) {
  Values law = {{"normal_stiffness", {hard_spring}}, {"normal_damping", {0}}};
  law.insert(law.end(), friction.begin(), friction.end());
  Scene s = test::scene(3, 1e-6, {test::body(1, swinging_radius, swinging_mass, {{0, 0, -pendulum}})}, law);
  hollow_values.insert(hollow_values.end(), {{"point", {0, 0, 0}}, {"radius", {hollow}}, {"side", {2}}});
  test::add_boundary(s, plugin, hollow_values);
  test::add_body_force(s, "gravity", {{"acceleration", {0, 0, -gravity}}});
  return assemble(Simulation(s), {.fewest_contacts = 1});
}

// ω² of all motions (1/s²), in ascending order.
Eigen::VectorXd squares(const LinearSystem& system) {
  const Eigen::VectorXd root = system.mass.cwiseSqrt().cwiseInverse();
  const Matrix weighted = root.asDiagonal() * Matrix(system.stiffness) * root.asDiagonal();
  Eigen::VectorXd all = weighted.eigenvalues().real();
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

// ω² = g/L. Round-off of sums of the contact's stiffness, 1e-16 of 1e9/2 over 11.
TEST_CASE("a bead without friction swings in a bowl in two directions, and in a trough in one",
          "[response]") {
  const Eigen::VectorXd bowl = squares(bead_in("sphere", {}, {})),
                        trough = squares(bead_in("cylinder", {{"axis", {0, 1, 0}}}, {}));
  REQUIRE(bowl.size() == 3);
  CHECK(bowl[0] == Approx(gravity / pendulum).epsilon(1e-8));
  CHECK(bowl[1] == Approx(gravity / pendulum).epsilon(1e-8));
  CHECK(bowl[2] == Approx(hard_spring / swinging_mass));
  REQUIRE(trough.size() == 3);
  CHECK(trough[0] == Approx(0).margin(1e-7));
  CHECK(trough[1] == Approx(gravity / pendulum).epsilon(1e-8));
}

// ω² = 5 g/(7 L) of a solid ball that rolls without slip. The spring of friction gives way by m g/(k_t R)
// = 2e-7, and the contact lies inside the ball by the overlap, 2e-7 of its radius.
TEST_CASE("a bead that rolls in a bowl swings as one that rolls without slip", "[response]") {
  const Values friction = {{"tangential_stiffness", {hard_spring}}, {"static_friction", {1}}};
  const Eigen::VectorXd bowl = squares(bead_in("sphere", {}, friction));
  REQUIRE(bowl.size() == 6);
  CHECK(std::abs(bowl[0]) < 1e-5);  // it turns about the normal
  CHECK(bowl[1] == Approx(5 * gravity / (7 * pendulum)).epsilon(1e-5));
  CHECK(bowl[2] == Approx(5 * gravity / (7 * pendulum)).epsilon(1e-5));
}
