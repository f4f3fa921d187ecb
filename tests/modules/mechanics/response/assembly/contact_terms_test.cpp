#include "assembly/contact_terms.hpp"

#include "scenes.hpp"

#include <cmath>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::response;
using scree::test::Values;

namespace {

constexpr double normal_spring = 1000, tangential_spring = 600;  // (N/m)

Values sticking_springs(double friction, double damping = 0) {
  return {{"normal_stiffness", {normal_spring}},
          {"normal_damping", {damping}},
          {"tangential_stiffness", {tangential_spring}},
          {"tangential_damping", {damping / 2}},
          {"static_friction", {friction}}};
}

// Two discs of radius 1, so heavy that only their velocities move them.
Scene pair_of_discs(const Values& law, double distance, double sideways = 0) {
  return test::scene(2, 1e-4,
                     {test::body(0, 1, 1e20, {}, {{0, sideways, 0}}, {}, 2),
                      test::body(1, 1, 1e20, {{distance, 0, 0}}, {}, {}, 2)},
                     law);
}

ContactTerms terms_of(const Simulation& simulation, AtLimit at_limit = AtLimit::slide) {
  const std::vector<ContactTerms> terms = linearise_contacts(simulation, 1, at_limit);
  REQUIRE(terms.size() == 1);
  return terms[0];
}

using Vector = Eigen::Matrix<double, 6, 1>;

}  // namespace

// In the order x, y, turn of each disc. The force f on disc 0 turns with the line of centres, which has the
// length d, and the contact slips by u_y + d/2 (θ_0 + θ_1). Dashpots have their values in the limit but for
// 1e-9.
TEST_CASE("the stiffness and damping of a pair of discs are those of their springs and dashpots",
          "[response]") {
  const double d = 1.9, damping = 3;
  const ContactTerms terms = terms_of(Simulation(pair_of_discs(sticking_springs(50, damping), d)));
  Vector along, across, slip;
  along << 1, 0, 0, -1, 0, 0;
  across << 0, 1, 0, 0, -1, 0;
  slip << 0, 1, d / 2, 0, -1, d / 2;
  const double force = normal_spring * (2 - d);
  CHECK(terms.force[0] == Approx(-force));
  const Eigen::MatrixXd stiffness = normal_spring * along * along.transpose() +
                                    tangential_spring * slip * slip.transpose() -
                                    force / d * across * across.transpose();
  const Eigen::MatrixXd dashpots =
      damping * along * along.transpose() + damping / 2 * slip * slip.transpose();
  CHECK((Eigen::MatrixXd(terms.stiffness) - stiffness).norm() < 1e-12 * stiffness.norm());
  CHECK((Eigen::MatrixXd(terms.damping) - dashpots).norm() < 1e-8 * dashpots.norm());
  CHECK(terms.tangential);
  CHECK_FALSE(terms.sliding);
  CHECK_FALSE(terms.one_way);
}

// With the normal n, t across it and the force f on disc 0: while it slides f keeps its direction to n and
// grows with the overlap; while it sticks the spring adds t tᵀ. The spring is at the limit to 1e-9 of the
// overlap.
TEST_CASE("at the limit of friction a contact slides on or sticks, as is asked for", "[response]") {
  const double friction = 0.02;
  Simulation simulation(pair_of_discs(sticking_springs(friction), 1.9, 1));
  test::run(simulation, 200);  // 0.02 m, ten times the slip to the limit
  for (const AtLimit limit : {AtLimit::slide, AtLimit::stick}) {
    const ContactTerms terms = terms_of(simulation, limit);
    REQUIRE(terms.sliding);
    const Eigen::Vector2d apart(
        simulation.particles().position()[0][0] - simulation.particles().position()[0][1],
        simulation.particles().position()[1][0] - simulation.particles().position()[1][1]);
    const double d = apart.norm();
    const Eigen::Vector2d n = apart / d, t(-n[1], n[0]), f = terms.force.head(2);
    CHECK(std::abs(f.dot(t)) == Approx(friction * f.dot(n)).epsilon(1e-6));
    Eigen::Matrix2d expected = normal_spring * n * n.transpose() - f.dot(n) / d * t * t.transpose() +
                               f.dot(t) / d * n * t.transpose();
    if (limit == AtLimit::slide)
      expected += normal_spring * f.dot(t) / f.dot(n) * t * n.transpose();
    else
      expected += tangential_spring * t * t.transpose();
    CHECK((Eigen::Matrix2d(terms.stiffness.topLeftCorner(2, 2)) - expected).norm() < 1e-6 * expected.norm());
  }
}
