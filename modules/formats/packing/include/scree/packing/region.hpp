#pragma once

#include <variant>

#include <scree/packing/packing.hpp>

namespace scree::packing {

// A ball; in two dimensions a circle.
struct Ball {
  Vec3 centre{};        // (m)
  double radius = 0.0;  // (m)
};

// A round cylinder, in three dimensions.
struct Cylinder {
  Vec3 centre{};        // (m) at half its length
  double radius = 0.0;  // (m)
  double length = 0.0;  // (m)
  int axis = 2;         // along which it is long: 0, 1, 2
};

// Part of space: a box (in two dimensions a rectangle), a ball or a cylinder.
using Region = std::variant<Bounds, Ball, Cylinder>;

// Volume (m³); in two dimensions the area (m²).
double volume_of(const Region& region, int dimension);
// The smallest box that holds the region (m).
Bounds bounds_of(const Region& region, int dimension);
// Whether a body lies wholly in the region, up to the rounding of coordinates. Only the first `dimension`
// axes count.
bool holds(const Region& region, int dimension, const Vec3& position, double radius);
// Volume (m³) of a sphere, or area (m²) of a disc.
double volume_of_body(double radius, int dimension);

}  // namespace scree::packing
