#pragma once

#include <algorithm>
#include <cstdint>

#include <scree/plugin/vec.hpp>

namespace scree {

// The part of a triangle that is nearest to a point: its face, an edge from the corner of that number to the
// next, or a corner.
enum class TrianglePart : std::uint8_t { face, edge_0, edge_1, edge_2, corner_0, corner_1, corner_2 };

// Whole triangle, with its unit normal.
struct Triangle {
  Vec3 corner[3];  // (m)
  Vec3 normal;
};

// Where a triangle is nearest to a point.
struct PointOnTriangle {
  Vec3 point;  // (m)
  TrianglePart part;
};

namespace detail {

inline PointOnTriangle on_edge(const Triangle& t, int edge, double share) {
  const Vec3 &from = t.corner[edge], &to = t.corner[(edge + 1) % 3];
  return {from + share * (to - from), TrianglePart(int(TrianglePart::edge_0) + edge)};
}
inline PointOnTriangle on_corner(const Triangle& t, int corner) {
  return {t.corner[corner], TrianglePart(int(TrianglePart::corner_0) + corner)};
}

}  // namespace detail

// The point of a triangle that is nearest to x (m). x lies beyond an edge if the edge, x and the normal say
// so, and beyond a corner if it also lies behind both ends.
inline PointOnTriangle nearest_on(const Triangle& t, const Vec3& x) {
  bool over_face = true;
  PointOnTriangle best = {};
  double best_square = 0;
  for (int e = 0; e < 3; ++e) {
    const Vec3 edge = t.corner[(e + 1) % 3] - t.corner[e], from = x - t.corner[e];
    if (dot(cross(edge, from), t.normal) >= 0) continue;
    const double along = dot(from, edge), square = dot(edge, edge);
    const PointOnTriangle here = along <= 0        ? detail::on_corner(t, e)
                                 : along >= square ? detail::on_corner(t, (e + 1) % 3)
                                                   : detail::on_edge(t, e, along / square);
    const Vec3 apart = x - here.point;
    if (over_face || dot(apart, apart) < best_square) best = here, best_square = dot(apart, apart);
    over_face = false;
  }
  if (!over_face) return best;
  return {x - dot(x - t.corner[0], t.normal) * t.normal, TrianglePart::face};
}

// Smallest and largest corners of a box.
struct Bounds {
  Vec3 lower, upper;

  void include(const Vec3& x) {
    for (int k = 0; k < 3; ++k) lower[k] = std::min(lower[k], x[k]), upper[k] = std::max(upper[k], x[k]);
  }
  // Square of the distance of a point (m²); 0 inside.
  double square_to(const Vec3& x) const {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const double beyond = std::max({lower[k] - x[k], x[k] - upper[k], 0.0});
      sum += beyond * beyond;
    }
    return sum;
  }
};

}  // namespace scree
