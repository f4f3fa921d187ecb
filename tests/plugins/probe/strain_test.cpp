#include "layer_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

namespace {

const Values layers = {{"low", {0.2}}, {"high", {0.8}}, {"half_width", {0.06}}};

}  // namespace

TEST_CASE("strain: that of a uniformly strained lattice, between any layers", "[strain]") {
  for (const int dimension : {2, 3})
    for (int axis = 0; axis < dimension; ++axis) {
      Simulation s(lattice_in_box(dimension, axis));
      Values by_height = layers,
             by_share = {{"low_share", {0.4}}, {"high_share", {0.6}}, {"half_width", {0.06}}};
      by_height.push_back({"axis", {double(axis)}});
      by_share.push_back({"axis", {double(axis)}});
      Probe wide = probe_of("strain", by_height, dimension), narrow = probe_of("strain", by_share, dimension);
      CHECK(sampled(wide, s)["strain"] == 0);
      CHECK(sampled(narrow, s)["strain"] == 0);
      run(s, 400);
      const Sampled of_wide = sampled(wide, s), of_narrow = sampled(narrow, s);
      CHECK(of_wide["distance"] == near(0.6 * (1 + 0.4 * lattice_rate), 2 * lattice_rounding));
      CHECK(of_narrow["distance"] == near(0.2 * (1 + 0.4 * lattice_rate), 2 * lattice_rounding));
      for (const Sampled* p : {&of_wide, &of_narrow}) {
        CHECK((*p)["bodies_low"] == 4);
        CHECK((*p)["bodies_high"] == 4);
        // Two means, each with its rounding, over the distance of 0.2 m at least.
        CHECK((*p)["strain"] == near(0.4 * lattice_rate, 2 * lattice_rounding / 0.2));
        CHECK((*p)["strain_rate"] == near(lattice_rate, 2 * lattice_rounding / 0.2));
      }
    }
}

TEST_CASE("strain: layers that cross a periodic face keep their distance and their strain", "[strain]") {
  for (const int dimension : {2, 3}) {
    Scene sc = lattice(dimension, 1);
    for (Body& b : sc.bodies) b.velocity[1] += 4;
    add_boundary(sc, "periodic", {{"lower", {0, 0, 0}}, {"upper", {1, 1, 1}}, {"axes", {1}}});
    Simulation s(sc);
    Probe p = probe_of("strain", layers, dimension);
    sampled(p, s);
    run(s, 200);  // 0.8 m, by which the upper layer has crossed the face
    REQUIRE(s.particles().image[1][15] == 1);
    REQUIRE(s.particles().image[1][1] == 0);
    CHECK(sampled(p, s)["strain"] == near(0.2 * lattice_rate, 2 * 2 * lattice_rounding / 0.6));
    CHECK(sampled(p, s)["strain_rate"] == near(lattice_rate, 2 * 4 * lattice_rounding / 0.6));
  }
}

TEST_CASE("strain: about the mean distance, from the strain since the start, as the probe says", "[strain]") {
  Simulation s(lattice_in_box(2, 1));
  Probe p = probe_of("strain", layers, 2);
  std::vector<double> strain, distance;
  double mean_strain = 0, mean_distance = 0;
  for (int k = 0; k < 4; ++k) {
    const Sampled row = sampled(p, s);
    strain.push_back(row["strain"]), distance.push_back(row["distance"]);
    mean_strain += 0.25 * strain.back(), mean_distance += 0.25 * distance.back();
    run(s, 100);
  }
  for (std::size_t k = 0; k < 4; ++k)
    CHECK((strain[k] - mean_strain) / (1 + mean_strain) ==
          near(distance[k] / mean_distance - 1, 4 * lattice_rounding));
}

TEST_CASE("strain: goes on after a resume, and sampling leaves the motion as it is", "[strain]") {
  Simulation s(lattice_in_box(3, 1));
  Probe p = probe_of("strain", layers, 3);
  sampled(p, s);
  run(s, 200);
  Probe q = resumed(p, "strain", layers, s);
  run(s, 200);
  CHECK(sampled(q, s).row == sampled(p, s).row);
  CHECK(sampled(q, s)["strain"] == near(0.4 * lattice_rate, 2 * lattice_rounding / 0.6));
  CHECK(leaves_the_motion("strain", layers));
}

TEST_CASE("strain: layers that overlap, also around a periodic axis, or are reversed are refused",
          "[strain]") {
  const auto check = [](const Scene& sc, double low, double high, double half_width) {
    sample(Simulation(sc), "strain", {{"low", {low}}, {"high", {high}}, {"half_width", {half_width}}});
  };
  Scene periodic = lattice(2, 1);
  add_boundary(periodic, "periodic", {{"lower", {0, 0, 0}}, {"upper", {1, 1, 1}}, {"axes", {1}}});
  CHECK_NOTHROW(check(lattice(2, 1), 0.05, 0.95, 0.06));
  CHECK_THROWS_WITH(check(periodic, 0.05, 0.95, 0.06), Catch::Contains("overlap"));
  CHECK_THROWS_WITH(check(lattice(2, 1), 0.2, 0.4, 0.1), Catch::Contains("smaller half_width"));
  CHECK_THROWS_WITH(check(lattice(2, 1), 0.8, 0.2, 0.06), Catch::Contains("reverse order"));
  CHECK_THROWS_WITH(check(lattice(2, 1), 0.2, 0.5, 0.01), Catch::Contains("no body lies within"));
}
