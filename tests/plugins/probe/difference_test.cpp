#include "probe_support.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/probes.hpp>

using namespace scree;
using namespace scree::test;

namespace {

Simulation three_bodies(int dimension) {
  const double z = dimension == 2 ? 0 : 1;
  return Simulation(scene(dimension, 1e-3,
                          {body(3, 0.5, 1, {{0, 0, 0}}, {{3, 4, 0}}, {{0, 0, 2}}, dimension),
                           body(5, 0.5, 1, {{2, 5, 7 * z}}, {{0, 2, 0}}, {{0, 0, -3}}, dimension),
                           body(9, 0.5, 1, {{-4, 0, z}}, {{0, 0, 12 * z}}, {{4 * z, 3 * z, 0}}, dimension)},
                          {{"normal_stiffness", {5000}}, {"normal_damping", {0}}}));
}

}  // namespace

TEST_CASE("difference: vectors and magnitudes of each pair, in the order given", "[probe]") {
  const Sampled d = sample(three_bodies(3), "difference", {{"ids", {5, 3, 3, 9}}});
  CHECK(d.row.size() == 22);
  CHECK(d["x_5_3"] == 2);
  CHECK(d["z_5_3"] == 7);
  CHECK(d["vx_5_3"] == -3);
  CHECK(d["vz_3_9"] == -12);
  CHECK(d["spin_z_5_3"] == -5);
  CHECK(d["spin_x_3_9"] == -4);
  CHECK(d["speed_5_3"] == 2 - 5);
  CHECK(d["spin_5_3"] == 3 - 2);
  CHECK(d["speed_3_9"] == 5 - 12);
  CHECK(d["spin_3_9"] == 2 - 5);
}

TEST_CASE("difference: discs have two axes and one spin", "[probe]") {
  const Sampled d = sample(three_bodies(2), "difference", {{"ids", {5, 3}}});
  CHECK(d.row.size() == 7);
  CHECK(d["y_5_3"] == 5);
  CHECK(d["vy_5_3"] == -2);
  CHECK(d["spin_z_5_3"] == -5);
  CHECK(d["speed_5_3"] == -3);
  CHECK(d["spin_5_3"] == 1);
}

TEST_CASE("difference: ids come in pairs and exist", "[probe]") {
  const Simulation s = three_bodies(3);
  CHECK_THROWS_WITH(sample(s, "difference", {{"ids", {3, 5, 9}}}), Catch::Contains("pairs"));
  CHECK_THROWS_WITH(sample(s, "difference", {{"ids", {3, 4}}}), Catch::Contains("does not exist"));
}
