#include "cloud_support.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <catch2/catch.hpp>

#include <scree/packing/overlap.hpp>
#include <scree/packing/random_cloud.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using scree::Vec3;

namespace {

const Bounds unit_box = {{}, {{1.0, 1.0, 1.0}}};

CloudOptions counted_in(const Region& region, std::int64_t count, int dimension = 3) {
  CloudOptions options;
  options.dimension = dimension;
  options.region = region;
  options.count = count;
  return options;
}

CloudOptions filling(const Region& region, double solid_fraction, int dimension = 3) {
  CloudOptions options = counted_in(region, 1, dimension);
  options.count.reset();
  options.solid_fraction = solid_fraction;
  return options;
}

std::string refusal_of_cloud(const CloudOptions& options, const RadiusDistribution& radii) {
  return error_of([&] { cloud_of(options, radii); });
}

// Volume of the bodies over that of the region.
double fraction_of(const Packing& packing, const Region& region) {
  return volume_of_bodies(packing) / volume_of(region, packing.dimension);
}

}  // namespace

TEST_CASE("bodies of a random cloud lie in their region and do not overlap, and no seed gives others",
          "[packing]") {
  const Region regions[] = {Bounds{{{-1.0, 2.0, 0.0}}, {{1.5, 4.0, 1.0}}}, Ball{{{1.0, 2.0, 3.0}}, 1.0},
                            Cylinder{{{1.0, 2.0, 3.0}}, 0.8, 3.0, 1}};
  for (const int dimension : {2, 3})
    for (const Region& region : regions) {
      if (dimension == 2 && std::holds_alternative<Cylinder>(region)) continue;
      const UniformRadius radii{0.01, 0.12};
      const CloudOptions options = filling(region, 0.25, dimension);
      const Packing packing = cloud_of(options, radii).packing;
      CAPTURE(dimension, region.index(), packing.bodies.size());
      CHECK(packing.bodies.size() > 30);
      for (const Body& body : packing.bodies) CHECK(holds(region, dimension, body.position, body.radius));
      CHECK_FALSE(find_overlap(packing));
      CHECK(same_bits(cloud_of(options, radii).packing, packing));
      CHECK_FALSE(same_bits(cloud_of(options, radii, 6).packing, packing));
    }
}

TEST_CASE("sizes of 1 to 50 keep clear of each other, of their images and of obstacles of any size",
          "[packing]") {
  const ListedRadius radii{{0.1, 0.05, 0.02, 0.01, 0.002}, {1, 8, 40, 200, 1000}};
  for (const int dimension : {2, 3}) {
    CloudOptions options = counted_in(unit_box, 2000, dimension);
    options.periodic = {true, false, dimension == 3};
    options.obstacles = {{{{-0.1, 0.5, 0.0}}, 0.3}, {{{2.5, 0.3, 0.0}}, 0.001}, {{{0.5, 0.9, 0.0}}, 0.02}};
    Packing packing = cloud_of(options, radii).packing;
    for (const auto& obstacle : options.obstacles) {
      Body body;
      body.id = std::int64_t(packing.bodies.size()) + 1;
      body.position = obstacle.position;
      body.radius = obstacle.radius;
      packing.bodies.push_back(body);
    }
    CHECK_FALSE(find_overlap(packing));  // across periodic faces too
    const bool reaches_through = std::any_of(
        packing.bodies.begin(), packing.bodies.end(),
        [](const Body& body) { return body.position[0] < body.radius && body.position[0] > 0.0; });
    CHECK(reaches_through);
  }
}

TEST_CASE("large bodies keep clear of obstacles that are far smaller", "[packing]") {
  Random random(3);
  CloudOptions options = counted_in(unit_box, 10);
  for (int n = 0; n < 100; ++n)
    options.obstacles.push_back({{{random.uniform(), random.uniform(), random.uniform()}}, 0.002});
  const Packing packing = cloud_of(options, ConstantRadius{0.08}, 6).packing;
  double least = 1.0;
  for (const Body& body : packing.bodies)
    for (const auto& obstacle : options.obstacles)
      least = std::min(least, norm(body.position - obstacle.position) - body.radius - obstacle.radius);
  CHECK(least >= 0.0);
  CHECK(least < 0.02);  // they come near
}

TEST_CASE("a solid fraction is met to rounding by one factor of all radii near 1", "[packing]") {
  // Rounding of a sum of some 1e3 volumes: 1e3 · 1e-16.
  for (const double fraction : {0.01, 0.1, 0.3})
    for (const RadiusDistribution& radii :
         {RadiusDistribution(ConstantRadius{0.05}), RadiusDistribution(NormalRadius{0.05, 0.02, 0.02, 0.1}),
          RadiusDistribution(BidisperseRadius{0.03, 0.06, 0.3})}) {
      const Cloud cloud = cloud_of(filling(unit_box, fraction), radii);
      CAPTURE(fraction, cloud.packing.bodies.size(), cloud.radius_factor);
      CHECK(fraction_of(cloud.packing, unit_box) == Approx(fraction).epsilon(1e-12));
      CHECK(cloud.solid_fraction == Approx(fraction).epsilon(1e-12));
      // Half a largest body more or less, in the number of bodies that there are.
      CHECK(std::abs(cloud.radius_factor - 1.0) <
            volume_of_body(largest_radius(radii), 3) / 6.0 / fraction * 1.2);
    }
  const Cloud flat = cloud_of(filling(unit_box, 0.4, 2), UniformRadius{0.01, 0.02});
  CHECK(fraction_of(flat.packing, unit_box) == Approx(0.4).epsilon(1e-12));
}

TEST_CASE("the density of a random cloud is uniform", "[packing]") {
  // chi-square of 64 cells at 63 degrees of freedom: 99.9 % of independent points are below 103.4, and bodies
  // that keep apart are more even. A periodic box has no layer along walls.
  CloudOptions options = counted_in(unit_box, 6400);
  options.periodic = {true, true, true};
  const Packing periodic = cloud_of(options, ConstantRadius{0.01}).packing;
  const Packing small = cloud_of(counted_in(unit_box, 6400), ConstantRadius{1e-5}).packing;
  for (const Packing& packing : {periodic, small}) {
    std::array<double, 64> cells{};
    for (const Body& body : packing.bodies) {
      std::size_t cell = 0;
      for (int k = 0; k < 3; ++k) cell = 4 * cell + std::size_t(4.0 * body.position[k]);
      cells.at(cell) += 1.0;
    }
    double chi_square = 0.0;
    for (const double n : cells) chi_square += (n - 100.0) * (n - 100.0) / 100.0;
    CHECK(chi_square < 103.4);
    CHECK(chi_square > 20.0);  // and not on a lattice
  }
}

TEST_CASE(
    "random sequential addition reaches 0.3 in three dimensions and 0.4 in two, and says what it can reach",
    "[packing]") {
  CHECK(cloud_of(filling(unit_box, 0.3), ConstantRadius{0.03}).solid_fraction == Approx(0.3));
  CHECK(cloud_of(filling(unit_box, 0.4, 2), ConstantRadius{0.01}).solid_fraction == Approx(0.4));
  // Saturation of equal bodies: 0.384 in 3D, 0.547 in 2D (Torquato & Stillinger 2010); less between walls.
  for (const int dimension : {2, 3}) {
    const std::string error = refusal_of_cloud(filling(unit_box, 0.6, dimension), ConstantRadius{0.03});
    CAPTURE(error);
    CHECK_THAT(error, StartsWith("random cloud: after ") && Contains(", a solid fraction of 0."));
    const double reached = std::stod(error.substr(error.find("fraction of ") + 12));
    CHECK(reached < (dimension == 2 ? 0.547 : 0.384));
    CHECK(reached > (dimension == 2 ? 0.44 : 0.3));
    const double told = std::stod(error.substr(error.find("at most ") + 8));
    CHECK(cloud_of(filling(unit_box, told, dimension), ConstantRadius{0.03}).solid_fraction == Approx(told));
  }
}

TEST_CASE("a random cloud that cannot be is refused with its cure", "[packing]") {
  CHECK(
      refusal_of_cloud(counted_in(unit_box, 1), ConstantRadius{0.6}) ==
      "random cloud: a body of radius 0.6 m does not fit into 1 m along x; give a larger region or smaller radii");
  CHECK_THAT(refusal_of_cloud(counted_in(Bounds{{}, {{1.0, 0.0, 1.0}}}, 1), ConstantRadius{0.1}),
             Contains("the region has no length along y; "));
  CHECK_THAT(refusal_of_cloud(counted_in(unit_box, 1), ConstantRadius{1e-10}),
             Contains("is below 1e-09 of the region"));
  CHECK_THAT(refusal_of_cloud(filling(unit_box, 0.1), ConstantRadius{0.45}),
             Contains("1 radius would have to be multiplied by 0.64 to meet the solid fraction; "));
  CHECK_THAT(refusal_of_cloud(filling(unit_box, 0.1), ListedRadius{{0.1, 0.2}, {}}),
             Contains("give weights"));
  CHECK_THAT(refusal_of_cloud(filling(unit_box, 0.3), ConstantRadius{1e-8}),
             Contains("needs about 7.16e+22 bodies"));
  CloudOptions taken = counted_in(unit_box, 3);
  taken.obstacles = {{{{0.5, 0.5, 0.5}}, 0.9}};
  CHECK_THAT(refusal_of_cloud(taken, ConstantRadius{0.1}),
             Contains("after 0 of 3 bodies, a solid fraction of 0, ") &&
                 Contains("give a region that other bodies leave free"));
}

TEST_CASE("the work of a random cloud grows as the number of its bodies", "[packing]") {
  // Distances per body, of eight times the bodies, without walls. What shares a place of the table by chance
  // counts too, so that they change by the share of the table that is used; N² would be a factor of 8.
  const auto work = [](double radius) {
    CloudOptions options = filling(unit_box, 0.2);
    options.periodic = {true, true, true};
    const Cloud cloud = cloud_of(options, UniformRadius{radius, 4.0 * radius});
    return double(cloud.distances) / double(cloud.packing.bodies.size());
  };
  const double few = work(0.01), many = work(0.005);
  CAPTURE(few, many);
  CHECK(few > 1.0);
  CHECK(many < 1.5 * few);
}
