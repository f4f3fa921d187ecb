#include "surfaces/normal_change.hpp"
#include "surfaces/placed_surface.hpp"

#include <array>
#include <cmath>

#include <scree/surface_place.hpp>

namespace scree {

namespace {

// Spots of a mesh within a distance (m) of x, the nearest first.
std::vector<NearestPoint> spots_within(const PlacedSurface& placed, const Vec3& x, double reach) {
  std::vector<NearTriangle> near;
  placed.mesh()->triangles().find_near(x, distance_slack * reach, near);
  return SpotFinder().find(*placed.mesh(), placed.rule(), {x, reach}, near);
}

// The spot of a mesh in the direction that is nearest to one of a body close by; that one if there is none.
NearestPoint spot_towards(const PlacedSurface& placed, const Vec3& x, const NearestPoint& close) {
  constexpr double further = 1.01;  // of the distance
  NearestPoint best = close;
  double best_cosine = -1;
  for (const NearestPoint& spot : spots_within(placed, x, further * std::abs(close.distance)))
    if (const double cosine = dot(spot.normal, close.normal); cosine > best_cosine)
      best = spot, best_cosine = cosine;
  return best;
}

// By differences of fourth order: laws have it times the spring and the overlap, so that 1e-8 of it is
// round-off.
std::array<Vec3, 6> change_of_normal_change(const PlacedSurface& placed, const BodyAtSurface& body,
                                            const Vec3& x, const NearestPoint& nearest) {
  const double step = 1e-4 * std::abs(nearest.distance);
  const auto at = [&](int axis, double along) {
    Vec3 moved = {};
    moved[axis] = along;
    const Vec3 there = x + placed.to_scene().back()(moved);
    return symmetric_components(
        normal_change_in_scene(placed, body.dimension, there,
                               placed.mesh() ? spot_towards(placed, there, nearest)
                                             : nearest_point(placed.surface(), body.dimension, there)));
  };
  std::array<Vec3, 6> change = {};
  for (int axis = 0; axis < body.dimension; ++axis) {
    const auto after = at(axis, step), before = at(axis, -step), late = at(axis, 2 * step),
               early = at(axis, -2 * step);
    for (std::size_t k = 0; k < 6; ++k)
      change[k][axis] = (8 * (after[k] - before[k]) - (late[k] - early[k])) / (12 * step);
  }
  return change;
}

// With the nearest point in the frame of the surface.
SurfacePlace place_of(const PlacedSurface& placed, const scree_surface& shape, const BodyAtSurface& body,
                      const Vec3& x, const NearestPoint& nearest) {
  const Rotation& rotation = placed.to_scene();
  const double of_body = 1 / body.radius, radius = effective_radius_at(nearest.curvature, of_body);
  const Matrix3 change = normal_change_in_scene(placed, body.dimension, x, nearest);
  SurfacePlace place = {
      {rotation(nearest.normal), nearest.distance},
      radius,
      {change, {}, body.follows ? change_of_normal_change(placed, body, x, nearest) : std::array<Vec3, 6>{}},
      {{rotation.real, rotation.axis[0], rotation.axis[1], rotation.axis[2]}},
      {nearest.point, nearest.normal}};
  if (placed.mesh()) return place;
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

std::vector<SurfaceSpot> spots_within(const WallSurfaces& all, const BodyAtSurface& body, double reach) {
  const PlacedSurface placed(all, body.surface, body.dimension, 0);
  const Vec3 x = placed.to_scene().back()(body.from_origin);
  std::vector<SurfaceSpot> found;
  for (const NearestPoint& spot : spots_within(placed, x, reach)) found.push_back({spot.point, spot.normal});
  return found;
}

std::vector<std::optional<SurfacePlace>> places_after(const WallSurfaces& all, const BodyAtSurface& body,
                                                      double reach, std::span<const SurfaceSpot> former) {
  const PlacedSurface placed(all, body.surface, body.dimension, 0);
  const Vec3 x = placed.to_scene().back()(body.from_origin);
  const std::vector<NearestPoint> spots = spots_within(placed, x, reach);
  std::vector<KeptSpot> kept;
  for (const SurfaceSpot& spot : former) kept.push_back({spot.point, spot.normal, kept.size()});
  SpotMatches matches;
  matches.find(placed.rule(), x, spots, kept);
  std::vector<std::optional<SurfacePlace>> found(former.size());
  for (std::size_t s = 0; s < spots.size(); ++s)
    if (matches[s] >= 0)
      found[std::size_t(matches[s])] = place_of(placed, all.shapes[body.surface], body, x, spots[s]);
  return found;
}

}  // namespace scree
