#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <scree/packing/packing.hpp>
#include <scree/packing/radius_distribution.hpp>
#include <scree/packing/random.hpp>
#include <scree/packing/region.hpp>
#include <scree/pair_search.hpp>

namespace scree::packing {

struct CloudOptions {
  int dimension = 3;
  Region region;
  // Axes along which a box is periodic: bodies reach through its faces, and are kept apart from their images.
  std::array<bool, 3> periodic{};
  // Give either the number of bodies (positive), or their volume over that of the region (above 0, below 1).
  std::optional<std::int64_t> count;
  std::optional<double> solid_fraction;
  // Bodies are placed with smaller radii and grow, so that the cloud can be denser than random places allow:
  // up to a solid fraction of some 0.55, of discs 0.8.
  bool growth = false;
  std::vector<Sphere> obstacles;  // of which bodies keep clear; they do not count in the solid fraction
};

struct Cloud {
  Packing packing;              // its bounds are those of the region
  double solid_fraction = 0.0;  // volume of the bodies over that of the region
  double radius_factor = 1.0;   // by which the drawn radii were multiplied to meet the solid fraction
  std::size_t distances = 0;    // that were computed, a measure of the work
};

inline constexpr std::int64_t max_cloud_bodies = 100'000'000;
// How many places are tried for one body.
inline constexpr int max_cloud_tries = 50'000;

// The number of bodies; for a solid fraction an estimate from some drawn radii.
double expected_count(const CloudOptions& options, const RadiusDistribution& radii, Random random);

// Bodies at random places of the region that overlap neither each other nor obstacles: random sequential
// addition, the largest first. Radii are drawn first; for a solid fraction as many as come nearest to it,
// which are then multiplied by one factor near 1, so that it is met to rounding. Ids are 1, 2, ... in the
// order in which the radii were drawn. Throws Error for invalid options, and if max_cloud_tries places in a
// row are taken: the message has the solid fraction that was reached. With growth likewise, and if the bodies
// jam before they have their radii.
Cloud fill_randomly(const CloudOptions& options, const RadiusDistribution& radii, Random& random);

}  // namespace scree::packing
