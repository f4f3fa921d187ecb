#pragma once

#include "surfaces/nearest_point.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <scree/plugin/abi.h>
#include <scree/plugin/vec.hpp>

// Nearest points of surfaces that are no meshes. All cases are computed and one is chosen, so that compilers
// make vectors of loops over many points.

namespace scree::shape {

inline double chosen(bool first, double a, double b) { return first ? a : b; }
template <int N>
Vec<N> chosen(bool first, const Vec<N>& a, const Vec<N>& b) {
  Vec<N> v;
  for (int k = 0; k < N; ++k) v[k] = first ? a[k] : b[k];
  return v;
}
inline NearestPoint chosen(bool first, const NearestPoint& a, const NearestPoint& b) {
  return {chosen(first, a.point, b.point), chosen(first, a.normal, b.normal),
          chosen(first, a.distance, b.distance), chosen(first, a.curvature, b.curvature)};
}

// From a face with this normal at its outside, a signed height (m) and the curvatures that its outside has.
inline NearestPoint on_face(std::uint32_t side, const Vec3& point, const Vec3& outwards, double height,
                            const Vec2& curvature) {
  const bool inside = (side == SCREE_INSIDE) | ((side == SCREE_BOTH_SIDES) & (height < 0));
  return {point, chosen(inside, -outwards, outwards), chosen(inside, -height, height),
          chosen(inside, -curvature, curvature)};
}

// From a point of an edge; straight up if the centre lies on it.
inline NearestPoint on_edge(const Vec3& point, const Vec3& x) {
  const Vec3 away = x - point;
  const double distance = norm(away);
  return {point, chosen(distance > 0, 1 / distance * away, Vec3{{0, 0, 1}}), distance, {}};
}

template <int D>
NearestPoint on_flat(const scree_surface& s, const Vec3& x) {
  constexpr int up = D - 1;
  Vec3 point = {}, outwards = {};
  outwards[up] = 1;
  bool over_face = true;
  for (int k = 0; k < up; ++k) {
    const double above = x[k] < -s.size[k] ? -s.size[k] : x[k];
    point[k] = s.size[k] < above ? s.size[k] : above;
    over_face = over_face & (point[k] == x[k]);
  }
  return chosen(over_face, on_face(s.side, point, outwards, x[up], {}), on_edge(point, x));
}

// In the half plane of the axis and x: distance from the axis, and z.
struct HalfPlane {
  Vec3 radial;  // unit
  double distance;

  explicit HalfPlane(const Vec3& x) : distance(std::sqrt(x[0] * x[0] + x[1] * x[1])) {
    radial = chosen(distance > 0, Vec3{{x[0] / distance, x[1] / distance, 0}}, Vec3{{1, 0, 0}});
  }
  Vec3 at(double radius, double z) const { return radius * radial + Vec3{{0, 0, z}}; }
};

// A cylinder without ends.
inline NearestPoint on_cylinder(const scree_surface& s, const Vec3& x) {
  const HalfPlane plane(x);
  const double r = s.size[0];
  return on_face(s.side, plane.at(r, x[2]), plane.radial, plane.distance - r, {{1 / r, 0}});
}

inline NearestPoint on_revolved(const scree_surface& s, const Vec3& x) {
  const HalfPlane plane(x);
  const double r = s.size[0], z = s.size[1];
  const double along_r = s.size[2] - r, along_z = s.size[3] - z,
               length = std::sqrt(along_r * along_r + along_z * along_z);
  const double u_r = along_r / length, u_z = along_z / length;
  const double place = (plane.distance - r) * u_r + (x[2] - z) * u_z;
  const double radius = r + place * u_r, height = (plane.distance - r) * u_z - (x[2] - z) * u_r;
  // Of a cone across its lines; along them it is straight.
  const double curvature = radius > 0 ? u_z / radius : 0;
  const NearestPoint face =
      on_face(s.side, plane.at(radius, z + place * u_z), plane.at(u_z, -u_r), height, {{curvature, 0}});
  const bool before = place<0, behind = place> length;
  const NearestPoint edge = on_edge(chosen(before, plane.at(r, z), plane.at(s.size[2], s.size[3])), x);
  return chosen(before | behind, edge, face);
}

// A point of the edge at a height of a sphere or circle that is cut there.
template <int D>
Vec3 rim_of(const scree_surface& s, double height, const Vec3& x) {
  const double radius = std::sqrt(std::max(0.0, s.size[0] * s.size[0] - height * height));
  if constexpr (D == 2)
    return {{std::copysign(radius, x[0]), height, 0}};
  else
    return HalfPlane(x).at(radius, height);
}

template <int D>
NearestPoint on_ball(const scree_surface& s, const Vec3& x) {
  const double radius = s.size[0], distance = norm(x);
  const Vec3 outwards = chosen(distance > 0, 1 / distance * x, Vec3{{1, 0, 0}});
  const double height = radius * outwards[D - 1];
  const NearestPoint face =
      on_face(s.side, radius * outwards, outwards, distance - radius, {{1 / radius, 1 / radius}});
  const bool below = height<s.size[1], above = height> s.size[2];
  const NearestPoint edge = on_edge(chosen(below, rim_of<D>(s, s.size[1], x), rim_of<D>(s, s.size[2], x)), x);
  return chosen(below | above, edge, face);
}

// Calls visit(nearest), where nearest(x) is the nearest point to x (m), in the frame of the surface.
template <int D, class Visit>
void with_nearest(const scree_surface& s, const Visit& visit) {
  if (s.shape == SCREE_FLAT)
    visit([&s](const Vec3& x) { return on_flat<D>(s, x); });
  else if (s.shape == SCREE_REVOLVED && std::isinf(s.size[1]))
    visit([&s](const Vec3& x) { return on_cylinder(s, x); });
  else if (s.shape == SCREE_REVOLVED)
    visit([&s](const Vec3& x) { return on_revolved(s, x); });
  else
    visit([&s](const Vec3& x) { return on_ball<D>(s, x); });
}

}  // namespace scree::shape
