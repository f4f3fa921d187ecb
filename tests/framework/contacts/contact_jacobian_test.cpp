#include "scenes.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/contact_columns.hpp>
#include <scree/contact_jacobian.hpp>

using namespace scree;

namespace {

constexpr double torsion_stiffness = 3;

ConfiguredLaw torsion(int dimension) {
  static PluginHost laws({SCREE_TEST_LAWS});
  Parameters law(laws.find("torsion", SCREE_CONTACT_LAW));
  law.set("stiffness", {torsion_stiffness});
  return ConfiguredLaw(law, dimension, no_bounds, no_bounds);
}

// Derivatives of the couple with the rotation of a by an angle about z: (components of the couple, axes).
std::vector<double> couple_by_rotation(int dimension, double angle) {
  const int spins = dimension == 2 ? 1 : 3;
  const ConfiguredLaw law = torsion(dimension);
  ContactColumns contact(1);
  contact.input(SCREE_OVERLAP) = 1e-3;
  if (dimension == 2) {
    contact.input(SCREE_ORIENTATION_A) = angle;
  } else {
    contact.input(SCREE_ORIENTATION_A, 0) = std::cos(0.5 * angle);
    contact.input(SCREE_ORIENTATION_A, 3) = std::sin(0.5 * angle);
    contact.input(SCREE_ORIENTATION_B, 0) = 1;
  }
  const ContactJacobian derivative(law, dimension);
  std::vector<double> jacobian, couple;
  derivative.evaluate(contact.batch(1e-6), std::vector<PairVariation>(SCREE_LANES), jacobian);
  const int first = derivative.first(PairMotion::rotation_a);
  for (int row = dimension; row < dimension + spins; ++row)
    for (int column = first; column < first + spins; ++column)
      couple.push_back(jacobian[std::size_t(row * derivative.columns() + column)]);
  return couple;
}

}  // namespace

TEST_CASE("a Jacobian contains the couple that a rotation of a causes", "[derivative]") {
  CHECK(couple_by_rotation(2, 0.4) == std::vector<double>{-torsion_stiffness});
  // c = −2k v, v: vector part of the quaternion. A rotation by ε e changes it by ½ ε (w e + e × v): for
  // v = (0, 0, s), w = cos(φ/2), s = sin(φ/2), the columns are −k (w, −s, 0), −k (s, w, 0), −k (0, 0, w).
  const double w = std::cos(0.2), s = std::sin(0.2);
  const double expected[] = {w, s, 0, -s, w, 0, 0, 0, w};
  const std::vector<double> couple = couple_by_rotation(3, 0.4);
  for (std::size_t k = 0; k < 9; ++k)
    CHECK(std::abs(couple[k] + torsion_stiffness * expected[k]) < 4e-16 * torsion_stiffness);
}
