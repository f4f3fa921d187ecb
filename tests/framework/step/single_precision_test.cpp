#include "scenes.hpp"

#include <catch2/catch.hpp>

#include <scree/single_precision.hpp>

using Catch::Contains;
using scree::single_precision_problem;

namespace {

// Two spheres of glass that meet at 1 m/s or more, with 50 steps in a contact of 5000 N/m.
scree::Scene two_spheres(double radius, double speed = 1) {
  const double mass = 4.0 / 3 * 3.14159 * 2500 * radius * radius * radius;
  const double step = 3.14159 * std::sqrt(mass / 2 / 5000) / 50;
  return scree::test::scene(3, step,
                            {scree::test::body(1, radius, mass, {}, {{speed, 0, 0}}),
                             scree::test::body(2, radius, mass, {{2.1 * radius, 0, 0}})},
                            {{"normal_stiffness", {5000}}, {"restitution", {0.7}}});
}

}  // namespace

TEST_CASE(
    "single precision holds scenes from grains of a tenth of a micrometre to rocks of a hundred metres") {
  for (const double radius : {1e-7, 1e-3, 1.0, 100.0})
    CHECK_FALSE(single_precision_problem(two_spheres(radius)));
}

TEST_CASE("single precision is refused for magnitudes, or products of them, beyond its range") {
  CHECK_THAT(single_precision_problem(two_spheres(1e-31)).value_or(""),
             Contains("a mass of some 1e-89 kg is outside 1e-34 to 1e+36, the range of single precision"));
  CHECK_THAT(single_precision_problem(two_spheres(1e-3, 1e22)).value_or(""), Contains("the square of "));
  CHECK(single_precision_problem(two_spheres(1e13)));
}
