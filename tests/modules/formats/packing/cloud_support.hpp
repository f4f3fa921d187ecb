#pragma once

#include "packing_support.hpp"

#include <scree/packing/random_cloud.hpp>

namespace scree::packing {

inline Cloud cloud_of(const CloudOptions& options, const RadiusDistribution& radii, std::uint64_t seed = 5) {
  Random random(seed);
  return fill_randomly(options, radii, random);
}

inline double volume_of_bodies(const Packing& packing) {
  double volume = 0.0;
  for (const Body& body : packing.bodies) volume += volume_of_body(body.radius, packing.dimension);
  return volume;
}

}  // namespace scree::packing
