#include "equilibrium/pair_place.hpp"

#include "scenes.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::response;

namespace {

Eigen::Vector3d vector(const Vec3& v) { return {v[0], v[1], v[2]}; }

// Two spheres and a floor; every body moves and turns.
struct Packing {
  Simulation simulation;
  DegreesOfFreedom freedom{3, 3, {true, true}, {true, true}, {false}};
  StaticConfiguration start;

  // distance: between the centres at the start, of radii 1 and 0.7
  explicit Packing(double distance) : simulation(scene(distance)), start(simulation) {}
  static Scene scene(double distance) {
    const Vec3 direction = 1 / std::sqrt(14.0) * Vec3{{1, 2, 3}};
    Scene s = test::scene(3, 1e-3,
                          {test::body(0, 1, 1, {{0, 0.99, 0}}),
                           test::body(1, 0.7, 1, Vec3{{0, 0.99, 0}} + distance * direction)},
                          {{"normal_stiffness", {1000}}, {"normal_damping", {0}}});
    test::add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}});
    return s;
  }
  PairPlace after(const StaticPair& pair, const Eigen::VectorXd& q) const {
    const StaticMotion motion(q, freedom, simulation.linear_walls());
    StaticConfiguration end = start;
    end.move(motion);
    return {simulation, pair, end, motion};
  }
  // Of 0.02, so that a pair with a gap of 0.005 begins to touch on the way if the bodies approach.
  Eigen::VectorXd motion() const {
    Eigen::VectorXd q(freedom.size());
    for (Eigen::Index k = 0; k < q.size(); ++k) q[k] = 0.02 * std::sin(1 + 1.9 * double(k));
    for (int k = 0; k < 3; ++k)
      q[freedom.translation(1, k)] = -0.02 * std::abs(q[freedom.translation(1, k)]) - 0.01;
    for (int k = 0; k < 3; ++k) q[freedom.translation(0, k)] = 0.003 * (k + 1) * (k == 1 ? -1 : 1);
    return q;
  }
};

}  // namespace

// Central differences of 1e-6: errors of 1e-12 by third derivatives and 1e-10 by round-off.
TEST_CASE("derivatives of the slip of a pair are those of its increment", "[response]") {
  for (const scree_arms arms : {SCREE_ARM_CONTACT_POINT, SCREE_ARM_RADIUS})
    for (const bool wall : {false, true})
      for (const double gap : {-0.02, 0.005}) {
        CAPTURE(arms, wall, gap);
        const Packing packing(1.7 + gap);
        const StaticPair pair{0, wall ? 2u : 1u, {}};
        const Eigen::VectorXd q = packing.motion();
        const PairPlace place = packing.after(pair, q);
        REQUIRE(place.overlap() > 0);
        const SlipDerivative derivative = place.slip_derivative(arms);
        const auto difference = [&](Eigen::Index k) -> Eigen::Vector3d {
          const Eigen::VectorXd change = 1e-6 * Eigen::VectorXd::Unit(q.size(), k);
          return Eigen::Vector3d(vector(packing.after(pair, q + change).tangential_increment(arms)) -
                                 vector(packing.after(pair, q - change).tangential_increment(arms))) /
                 2e-6;
        };
        for (int k = 0; k < 3; ++k) {
          CHECK((derivative.by_displacement.col(k) - difference(packing.freedom.translation(0, k))).norm() <
                1e-8);
          CHECK((derivative.by_rotation_a.col(k) - difference(packing.freedom.rotation(0, k))).norm() < 1e-8);
          if (wall) continue;
          CHECK((-derivative.by_displacement.col(k) - difference(packing.freedom.translation(1, k))).norm() <
                1e-8);
          CHECK((derivative.by_rotation_b.col(k) - difference(packing.freedom.rotation(1, k))).norm() < 1e-8);
        }
      }
}

// Both turn by θ about the first centre: the normal in the middle is that after θ/2, and the slip is of third
// order.
TEST_CASE("a pair that turns as one does not slip", "[response]") {
  const Packing packing(1.68);
  for (const double angle : {0.02, 0.01}) {
    const Eigen::Vector3d axis = Eigen::Vector3d(2, -1, 1).normalized(),
                          arm = vector(packing.start.position[1] - packing.start.position[0]);
    const Eigen::Vector3d moved = Eigen::AngleAxisd(angle, axis) * arm - arm;
    Eigen::VectorXd q = Eigen::VectorXd::Zero(packing.freedom.size());
    q.segment(packing.freedom.translation(1, 0), 3) = moved;
    for (const std::size_t body : {0, 1}) q.segment(packing.freedom.rotation(body, 0), 3) = angle * axis;
    const Vec3 slip = packing.after({0, 1, {}}, q).tangential_increment(SCREE_ARM_CONTACT_POINT);
    CHECK(norm(slip) < std::pow(angle, 3));
  }
}

TEST_CASE("a pair is where its nearest images are", "[response]") {
  const Packing packing(1.68);
  const Vec3 shift = {{5, 0, 0}};
  const PairPlace place = packing.after({0, 1, shift}, Eigen::VectorXd::Zero(packing.freedom.size()));
  const Vec3 apart = packing.start.position[0] - packing.start.position[1] + shift;
  CHECK(place.distance == Approx(norm(apart)));
  CHECK(norm(place.normal - 1 / norm(apart) * apart) < 1e-15);
  CHECK(place.overlap() == Approx(1.7 - norm(apart)));
  const PairPlace floor = packing.after({0, 2, {}}, Eigen::VectorXd::Zero(packing.freedom.size()));
  CHECK(floor.to_wall());
  CHECK(floor.overlap() == Approx(0.01));
  CHECK(floor.normal == Vec3{{0, 1, 0}});
}
