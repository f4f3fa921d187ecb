#include "assembly/contact_geometry.hpp"

#include "packings.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::response;

TEST_CASE("the matrix of a cross product has the spins of the dimension", "[response]") {
  const Eigen::Vector3d v(1, -2, 3), turn(0.3, 0.5, -0.7);
  const Eigen::Matrix3d change = Eigen::Matrix3d::Zero();
  const ContactGeometry solid{3, 3, v, 1, 1, change, false}, plane{2, 1, v, 1, 1, change, false};
  CHECK((Eigen::Vector3d(solid.crossing(v) * turn) - v.cross(turn)).norm() < 1e-15);
  const Eigen::Vector2d in_plane = plane.crossing(v) * turn.tail(1);
  CHECK((in_plane - v.cross(Eigen::Vector3d(0, 0, turn[2])).head(2)).norm() < 1e-15);
}

// Both bodies turn about an axis across their normal: springs and overlap stay, and the force turns with
// them. Round-off of sums of stiffnesses, 1e-16 of 1e3 over forces of 10.
TEST_CASE("two bodies that turn as one take their force along", "[response]") {
  const test::Values law = {{"normal_stiffness", {1000}},
                            {"normal_damping", {0}},
                            {"tangential_stiffness", {600}},
                            {"static_friction", {50}}};
  for (const int dimension : {2, 3}) {
    const int spins = dimension == 2 ? 1 : 3, of_body = dimension + spins;
    const Scene scene = test::heap(dimension, law);
    const Simulation simulation(scene, test::strained(scene));
    const Particles& p = simulation.particles();
    const auto place_of = [&](std::uint32_t i) {
      const Vec3 x = p.body(i).position;
      return Eigen::Vector3d(x[0], x[1], x[2]);
    };
    int pairs = 0;
    for (const ContactTerms& contact : linearise_contacts(simulation, spins, AtLimit::slide)) {
      if (contact.b >= p.size()) continue;
      ++pairs;
      const Eigen::Vector3d apart = (place_of(contact.a) - place_of(contact.b)).normalized();
      const Eigen::Vector3d axis = dimension == 2
                                       ? Eigen::Vector3d(0, 0, 1)
                                       : Eigen::Vector3d(apart.cross(Eigen::Vector3d(0.3, -0.5, 0.8)));
      Eigen::VectorXd turning(2 * of_body);
      for (const std::uint32_t end : {contact.a, contact.b}) {
        const Eigen::Index first = end == contact.a ? 0 : of_body;
        turning.segment(first, dimension) = axis.cross(place_of(end)).head(dimension);
        turning.segment(first + dimension, spins) = axis.tail(spins);
      }
      const Eigen::VectorXd change = -contact.stiffness * turning;
      const Eigen::Vector3d turned = axis.cross(contact.force);
      CHECK((change.head(dimension) - turned.head(dimension)).norm() < 1e-10);
      CHECK((change.segment(of_body, dimension) + turned.head(dimension)).norm() < 1e-10);
    }
    CHECK(pairs > 2);
  }
}
