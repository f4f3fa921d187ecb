#include "probe_support.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// Two bodies below z = 5 m with velocities 1 and 3 along x, two above with 7 and 7, and spins about z.
Scene layered(int dimension) {
  const auto at = [&](double height) { return dimension == 2 ? Vec3{0, height, 0} : Vec3{0, 0, height}; };
  Scene s = scene(
      dimension, 1e-4,
      {body(1, 0.1, 2, at(1), {1, 0, 0}, {0, 0, 5}, dimension),
       body(2, 0.1, 6, at(4), {3, 0, 0}, {0, 0, 9}, dimension),
       body(3, 0.1, 1, at(6), {7, 0, 0}, {}, dimension), body(4, 0.1, 1, at(9), {7, 0, 0}, {}, dimension)},
      elastic_law);
  s.spin = true;
  return s;
}
Values two_layers(int dimension) {
  return {{"region", {1}},
          {"lower", {-1, dimension == 2 ? 0.0 : -1, 0}},
          {"upper", {1, dimension == 2 ? 10.0 : 1, 10}},
          {"bins", {2}},
          {"along", {dimension == 2 ? 1.0 : 2}}};
}

}  // namespace

TEST_CASE("temperature: about the mean velocity and spin of each layer", "[probe]") {
  for (const int dimension : {2, 3}) {
    const Simulation s(layered(dimension));
    const Sampled row = sample(s, "temperature", two_layers(dimension));
    // Mean (2·1 + 6·3)/8 = 2.5 m/s: (2·2.25 + 6·0.25)/(D·2). Spins 7 ± 2 rad/s.
    CHECK(row["bodies_1"] == 2);
    CHECK(row["translational_1"] == Approx(6.0 / (2 * dimension)));
    const double inertia = (dimension == 2 ? 0.5 : 0.4) * 0.01;
    CHECK(row["rotational_1"] == Approx(inertia * (2 + 6) * 4 / (2 * (dimension == 2 ? 1 : 3))));
    CHECK(row["translational_2"] == 0);
    CHECK(row["rotational_2"] == 0);
    const Sampled velocity = sample(s, "velocity", two_layers(dimension));
    CHECK(velocity["bodies_2"] == 2);
    CHECK(velocity["x_1"] == Approx(2.5));
    CHECK(velocity["y_1"] == 0);
    CHECK(velocity["x_2"] == Approx(7));
    CHECK(velocity["spin_z_1"] == Approx(7));
  }
}

TEST_CASE("temperature and velocity: bodies that are left out, and bins without bodies, do not count",
          "[probe]") {
  const Simulation s(layered(3));
  const Sampled row = sample(s, "temperature", two_layers(3), {1, 0, 1, 1});
  CHECK(row["bodies_1"] == 1);
  CHECK(row["translational_1"] == 0);
  CHECK(row["bodies_2"] == 0);
  CHECK(std::isnan(row["translational_2"]));
  CHECK(std::isnan(sample(s, "velocity", two_layers(3), {1, 0, 1, 1})["x_2"]));
}
