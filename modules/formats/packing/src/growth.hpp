#pragma once

#include <vector>

#include <scree/packing/random_cloud.hpp>

namespace scree::packing {

// Bodies that do not overlap at radii * first (first below 1, above 0) grow together to their radii, and push
// each other out of the way: geometry alone, without forces. Returns their places, at which they overlap
// neither each other nor the obstacles. Throws Error if they jam before: the message has the solid fraction
// that was reached.
std::vector<Vec3> grow(const CloudOptions& options, const std::vector<double>& radii,
                       const std::vector<Sphere>& obstacles, std::vector<Vec3> places, double first);

}  // namespace scree::packing
