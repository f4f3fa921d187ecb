#include "surfaces/normal_change.hpp"
#include "surfaces/placed_surface.hpp"

#include <scree/surface_place.hpp>

namespace scree {

namespace {

Matrix3 turned(const Rotation& rotation, const Matrix3& matrix) {
  Matrix3 all = {};
  for (std::size_t k = 0; k < 3; ++k) {
    Vec3 axis = {};
    axis[int(k)] = 1;
    const Vec3 row = rotation(matrix[k]), turned_axis = rotation(axis);
    for (std::size_t i = 0; i < 3; ++i) all[i] += turned_axis[int(i)] * row;
  }
  return all;
}

// With the nearest point in the frame of the surface.
SurfacePlace place_of(const PlacedSurface& placed, const scree_surface& shape, const BodyAtSurface& body,
                      const Vec3& x, const NearestPoint& nearest) {
  const Rotation& rotation = placed.to_scene();
  const double of_body = 1 / body.radius, radius = effective_radius_at(nearest.curvature, of_body);
  SurfacePlace place = {{rotation(nearest.normal), nearest.distance}, radius, {}};
  if (placed.mesh()) {
    place.change.normal = turned(rotation, normal_change(*placed.mesh(), x, nearest));
    return place;
  }
  place.change.normal = turned(rotation, normal_change(shape, body.dimension, x, nearest));
  // ∂R*/∂κ₁ = −R*/(2 (1/R + κ₁)) where R* is not limited.
  const double together = of_body + nearest.curvature[0];
  if (together > of_body / largest_effective_radius)
    place.change.effective_radius = -0.5 * radius / together * rotation(curvature_change(shape, x, nearest));
  return place;
}

}  // namespace

SurfacePlace nearest_place(const WallSurfaces& all, const BodyAtSurface& body) {
  const PlacedSurface placed(all, body.surface, body.dimension, 0);
  const scree_surface& shape = all.shapes[body.surface];
  const Vec3 x = placed.to_scene().back()(body.from_origin);
  return place_of(placed, shape, body, x, nearest_point(shape, body.dimension, x));
}

SurfacePlace place_towards(const WallSurfaces& all, const BodyAtSurface& body,
                           const PairDirection<3>& direction) {
  const PlacedSurface placed(all, body.surface, body.dimension, 0);
  if (!placed.mesh()) return nearest_place(all, body);
  const Rotation back = placed.to_scene().back();
  const Vec3 x = back(body.from_origin), normal = back(direction.normal);
  return place_of(placed, all.shapes[body.surface], body, x,
                  {x - direction.distance * normal, normal, direction.distance, {}});
}

}  // namespace scree
