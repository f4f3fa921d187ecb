#include "cloud_support.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include <scree/packing/overlap.hpp>
#include <scree/packing/random_cloud.hpp>

using namespace scree::packing;
using scree::Sphere;
using scree::Vec3;

namespace {

CloudOptions growing(const Region& region, double solid_fraction, int dimension) {
  CloudOptions options;
  options.dimension = dimension;
  options.region = region;
  options.solid_fraction = solid_fraction;
  options.growth = true;
  return options;
}

}  // namespace

TEST_CASE(
    "bodies that grow fill regions to a solid fraction that random places do not reach, without overlaps",
    "[packing]") {
  const Region regions[] = {Bounds{{{-1.0, 2.0, 0.0}}, {{1.0, 3.0, 1.5}}}, Ball{{{1.0, 2.0, 3.0}}, 0.9},
                            Cylinder{{{1.0, 2.0, 3.0}}, 0.5, 2.0, 1}};
  for (const int dimension : {2, 3})
    for (const Region& region : regions) {
      if (dimension == 2 && std::holds_alternative<Cylinder>(region)) continue;
      const double wanted = dimension == 2 ? 0.72 : 0.5;
      const Cloud cloud = cloud_of(growing(region, wanted, dimension), UniformRadius{0.06, 0.1});
      CAPTURE(dimension, region.index(), cloud.packing.bodies.size());
      // Met to rounding of the sum.
      CHECK(cloud.solid_fraction == Approx(wanted).epsilon(1e-12));
      CHECK(volume_of_bodies(cloud.packing) / volume_of(region, dimension) == Approx(wanted).epsilon(1e-12));
      CHECK_FALSE(find_overlap(cloud.packing));
      for (const Body& body : cloud.packing.bodies)
        CHECK(holds(region, dimension, body.position, body.radius));
    }
}

TEST_CASE("bodies that grow in a periodic box keep clear of images and of obstacles, which stay",
          "[packing]") {
  CloudOptions options = growing(Bounds{{}, {{1.0, 1.0, 1.0}}}, 0.45, 3);
  options.periodic = {true, false, true};
  options.obstacles = {{{{0.0, 0.5, 1.0}}, 0.3}, {{{5.0, 5.0, 5.0}}, 1.0}};
  const Cloud cloud = cloud_of(options, ConstantRadius{0.05});
  CHECK_FALSE(find_overlap(cloud.packing));
  for (const Body& body : cloud.packing.bodies) {
    Vec3 apart = body.position - options.obstacles[0].position;
    for (const int k : {0, 2}) apart[k] -= std::round(apart[k]);
    CHECK(norm(apart) >= body.radius + 0.3);
  }
}

TEST_CASE(
    "bodies that grow have the same places for the same seed, and are as before where random places suffice",
    "[packing]") {
  const Region box = Bounds{{}, {{1.0, 1.0, 1.0}}};
  const CloudOptions dense = growing(box, 0.4, 3);
  CHECK(same_bits(cloud_of(dense, ConstantRadius{0.08}).packing,
                  cloud_of(dense, ConstantRadius{0.08}).packing));
  CHECK_FALSE(same_bits(cloud_of(dense, ConstantRadius{0.08}, 6).packing,
                        cloud_of(dense, ConstantRadius{0.08}).packing));
  CloudOptions thin = growing(box, 0.15, 3);
  const Packing grown = cloud_of(thin, ConstantRadius{0.08}).packing;
  thin.growth = false;
  CHECK(same_bits(grown, cloud_of(thin, ConstantRadius{0.08}).packing));
}

TEST_CASE("bodies that jam before they have their radii are refused with the fraction that they reach",
          "[packing]") {
  // Above the densest packing of spheres, 0.74.
  const std::string text = error_of([] {
    cloud_of(growing(Bounds{{}, {{1.0, 1.0, 1.0}}}, 0.78, 3), ConstantRadius{0.12});
  });
  CHECK_THAT(text, Catch::Contains("bodies that grow to their radii jam at") &&
                       Catch::Contains("a solid fraction of 0."));
}

TEST_CASE("bodies that grow stay in a region that is as wide as they are", "[packing]") {
  // A layer, a row and a single body: the excess by which they grow does not fit.
  const Region regions[] = {Bounds{{}, {{1.0, 1.0, 0.2}}}, Cylinder{{}, 0.1, 1.0, 1}, Ball{{}, 0.1}};
  const std::uint64_t counts[] = {16, 4, 1};
  for (std::size_t k = 0; k < 3; ++k) {
    CloudOptions options;
    options.region = regions[k];
    options.count = counts[k];
    options.growth = true;
    const Cloud cloud = cloud_of(options, ConstantRadius{0.1});
    CHECK_FALSE(find_overlap(cloud.packing));
    const Bounds box = bounds_of(options.region, 3);
    for (const Body& body : cloud.packing.bodies) {
      // Round-off of coordinates near 1.
      CHECK(holds(regions[k], 3, body.position, body.radius * (1 - 1e-14)));
      for (int axis = 0; axis < 3; ++axis) CHECK(std::isfinite(body.position[axis]));
      CHECK(body.position[2] == Approx(0.5 * (box.lower[2] + box.upper[2])).margin(1e-15));
    }
  }
}
