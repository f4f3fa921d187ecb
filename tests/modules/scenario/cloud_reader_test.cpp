#include "discs_tables.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;

namespace {

const std::string cloud_region = "region = { x = [0, 1], y = [0, 0.5] }\n";
const std::string cloud =
    "[[particles]]\nname = 'cloud'\nrandom = { count = 40 }\n" + cloud_region + "radius = 0.02\n";

std::string refused_cloud(const std::string& part, const std::string& other) {
  return refusal(scene_with_lots(with(cloud, part, other)));
}

double least_gap(const std::vector<Body>& bodies) {
  double least = INFINITY;
  for (std::size_t a = 0; a < bodies.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      least = std::min(least,
                       norm(bodies[a].position - bodies[b].position) - bodies[a].radius - bodies[b].radius);
  return least;
}

}  // namespace

TEST_CASE("bodies at random lie in their region, clear of those of all other tables", "[scenario]") {
  const std::string other = "[[particles]]\nlattice = { kind = 'square', count = [9, 2] }\nradius = 0.04\n";
  const std::string single = "[[particle]]\nposition = [0.5, 0.35]\nradius = 0.14\n";
  const Plan plan = plan_of(scene_with_lots(cloud + other + with(cloud, "'cloud'", "'more'") + single));
  const std::vector<Body>& bodies = plan.scene.bodies;
  REQUIRE(bodies.size() == 40 + 18 + 40 + 1);
  CHECK(least_gap({bodies.begin(), bodies.begin() + 40}) >= 0);
  CHECK(least_gap(bodies) >= -1e-15);  // those on the lattice touch, to rounding
  for (const std::size_t k : {0, 39, 58, 97}) {
    CHECK(bodies[k].radius == 0.02);
    CHECK(std::abs(bodies[k].position[0] - 0.5) <= 0.48);
    CHECK(std::abs(bodies[k].position[1] - 0.25) <= 0.23);
  }
  CHECK(plan.body_sources[0].text() == "cloud: 40 bodies at random, solid fraction 0.100531; ids 1 to 40");
  CHECK(plan.body_sources[2].text() == "more: 40 bodies at random, solid fraction 0.100531; ids 59 to 98");
}

TEST_CASE("a solid fraction at random is met, and its radii are those of the distribution", "[scenario]") {
  const Plan plan = plan_of(
      scene_with_lots("[particles]\nrandom = { solid_fraction = 0.35, periodic = 'x' }\n" + cloud_region +
                      "radius = { distribution = 'uniform', minimum = 0.005, maximum = 0.01 }\n"));
  double area = 0;
  for (const Body& body : plan.scene.bodies) {
    area += std::numbers::pi * body.radius * body.radius;
    CHECK(std::abs(body.radius - 0.0075) < 0.00255);  // the factor is within a per cent for 1000 bodies
  }
  CHECK(area / 0.5 == Approx(0.35).epsilon(1e-12));
  REQUIRE(plan.warnings.size() == 1);
  CHECK_THAT(plan.warnings[0], Catch::StartsWith("the file of bodies is periodic along x from 0 to 1 m"));
}

TEST_CASE("a region is a box, a sphere or a cylinder", "[scenario]") {
  const std::string base = with(discs, "dimension = 2\n", "dimension = 3\n");
  const auto bodies = [&](const std::string& keys) {
    return plan_of(
               with(with(base, particles_of_discs,
                         "[particles]\nrandom = { count = 30 }\nradius = 0.05\nregion = { " + keys + " }\n"),
                    "x_low = 'fixed'\nx_high = 'fixed'\ny_low = 'fixed'\ny_high = 'fixed'\n",
                    "x = 'fixed'\ny = 'fixed'\nz = 'fixed'\n"))
        .scene.bodies;
  };
  for (const Body& body : bodies("kind = 'sphere', centre = [1, 2, 3], radius = 0.5"))
    CHECK(norm(body.position - Vec3{{1, 2, 3}}) <= 0.45);
  for (const Body& body :
       bodies("kind = 'cylinder', centre = [1, 2, 3], radius = 0.3, length = 2, axis = 'y'")) {
    CHECK(std::hypot(body.position[0] - 1, body.position[2] - 3) <= 0.25);
    CHECK(std::abs(body.position[1] - 2) <= 0.95);
  }
  CHECK(refusal(scene_with_lots("[particles]\nrandom = { count = 3 }\nradius = 1\n"
                                "region = { kind = 'cylinder', centre = [0, 0], radius = 9 }\n")) ==
        "scene.toml:16:19: a cylinder needs three dimensions; give kind = \"sphere\" for a circle");
}

TEST_CASE("keys of bodies at random that do not fit together are refused", "[scenario]") {
  CHECK(refused_cloud("count = 40", "count = 40, solid_fraction = 0.1") ==
        "scene.toml:15:10: each of count and solid_fraction is given; give one of them");
  CHECK_THAT(refused_cloud("count = 40", ""), Catch::Contains("none of count and solid_fraction is given"));
  CHECK_THAT(refused_cloud("count = 40", "solid_fraction = 0.9"),
             Catch::StartsWith("scene.toml:15:10: random cloud: after ") &&
                 Catch::Contains("give a solid fraction of at most 0."));
  CHECK_THAT(refused_cloud("[0, 1]", "[1, 0]"),
             Catch::Contains("1 is not below 0; give the lower limit first"));
  CHECK_THAT(refused_cloud(cloud_region, ""), Catch::Contains("region"));
  CHECK_THAT(refused_cloud("count = 40", "count = 40, periodic = 'yz'"),
             Catch::Contains("'yz' is not a list of axes; give \"x\", \"y\" or \"xy\""));
  CHECK_THAT(refused_cloud("random = {", "lattice = { count = 3 }\nrandom = {"),
             Catch::Contains("both a lattice and random are given; keep one of them"));
}
