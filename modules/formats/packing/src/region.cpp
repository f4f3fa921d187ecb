#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <scree/packing/region.hpp>

namespace scree::packing {

namespace {

using std::numbers::pi;

// Distance (m) of two points, without the difference along one axis.
double distance(Vec3 a, const Vec3& b, int without) {
  a[without] = b[without];
  return norm(a - b);
}

}  // namespace

double volume_of_body(double radius, int dimension) {
  return dimension == 2 ? pi * radius * radius : 4.0 / 3.0 * pi * radius * radius * radius;
}

double volume_of(const Region& region, int dimension) {
  if (const auto* ball = std::get_if<Ball>(&region)) return volume_of_body(ball->radius, dimension);
  if (const auto* c = std::get_if<Cylinder>(&region)) return pi * c->radius * c->radius * c->length;
  const Bounds& box = std::get<Bounds>(region);
  double volume = 1.0;
  for (int k = 0; k < dimension; ++k) volume *= box.upper[k] - box.lower[k];
  return volume;
}

Bounds bounds_of(const Region& region, int dimension) {
  if (const auto* box = std::get_if<Bounds>(&region)) return *box;
  Vec3 centre, half{};
  if (const auto* ball = std::get_if<Ball>(&region)) {
    centre = ball->centre;
    for (int k = 0; k < dimension; ++k) half[k] = ball->radius;
  } else {
    const Cylinder& c = std::get<Cylinder>(region);
    centre = c.centre;
    for (int k = 0; k < 3; ++k) half[k] = k == c.axis ? 0.5 * c.length : c.radius;
  }
  return {centre - half, centre + half};
}

bool holds(const Region& region, int dimension, const Vec3& position, double radius) {
  const Bounds box = bounds_of(region, dimension);
  for (int k = 0; k < dimension; ++k) {
    const double rounding = 4.0 * std::numeric_limits<double>::epsilon() *
                            std::max(std::abs(box.lower[k]), std::abs(box.upper[k]));
    if (position[k] - radius < box.lower[k] - rounding || position[k] + radius > box.upper[k] + rounding)
      return false;
  }
  if (const auto* c = std::get_if<Cylinder>(&region))
    return distance(position, c->centre, c->axis) <= c->radius - radius;
  if (const auto* ball = std::get_if<Ball>(&region)) {
    const Vec3& centre = ball->centre;
    return (dimension == 2 ? distance(position, centre, 2) : norm(position - centre)) <=
           ball->radius - radius;
  }
  return true;
}

}  // namespace scree::packing
