#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include <scree/plugin/vec.hpp>

namespace scree {

// The part of a triangle that is nearest to a point: its face, an edge from the corner of that number to the
// next, or a corner.
enum class TrianglePart : std::uint8_t { face, edge_0, edge_1, edge_2, corner_0, corner_1, corner_2 };

// A triangle with its unit normal, and in its plane the unit normals of its edges, which lead out of it.
struct Triangle {
  Vec3 corner[3];  // (m)
  Vec3 normal;
  Vec3 beyond[3];  // of the edge from the corner of that number to the next

  Triangle(const Vec3& a, const Vec3& b, const Vec3& c) : corner{a, b, c} {
    const Vec3 area = cross(b - a, c - a);
    normal = 1 / norm(area) * area;
    for (int e = 0; e < 3; ++e) {
      const Vec3 out = cross(corner[(e + 1) % 3] - corner[e], normal);
      beyond[e] = 1 / norm(out) * out;
    }
  }
};

// Where a triangle is nearest to a point.
struct PointOnTriangle {
  Vec3 point;  // (m)
  TrianglePart part;
};

namespace detail {

// The point of an edge that is nearest to x.
inline PointOnTriangle nearest_on_edge(const Triangle& t, int e, const Vec3& x) {
  const int next = (e + 1) % 3;
  const Vec3 edge = t.corner[next] - t.corner[e];
  const double along = dot(x - t.corner[e], edge), square = dot(edge, edge);
  if (along <= 0) return {t.corner[e], TrianglePart(int(TrianglePart::corner_0) + e)};
  if (along >= square) return {t.corner[next], TrianglePart(int(TrianglePart::corner_0) + next)};
  return {t.corner[e] + along / square * edge, TrianglePart(int(TrianglePart::edge_0) + e)};
}

}  // namespace detail

// The point of a triangle that is nearest to x (m): on its face, or on one of the edges beyond which x lies.
inline PointOnTriangle nearest_on(const Triangle& t, const Vec3& x) {
  PointOnTriangle best = {{}, TrianglePart::face};
  double best_square = 0;
  for (int e = 0; e < 3; ++e) {
    if (!(dot(x - t.corner[e], t.beyond[e]) > 0)) continue;
    const PointOnTriangle here = detail::nearest_on_edge(t, e, x);
    const Vec3 apart = x - here.point;
    const double square = dot(apart, apart);
    if (best.part == TrianglePart::face || square < best_square) best = here, best_square = square;
  }
  if (best.part == TrianglePart::face) best.point = x - dot(x - t.corner[0], t.normal) * t.normal;
  return best;
}

// Smallest and largest corners of a box.
struct Bounds {
  Vec3 lower, upper;

  // Of no point.
  static constexpr Bounds nowhere() {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    return {{{infinite, infinite, infinite}}, {{-infinite, -infinite, -infinite}}};
  }
  void include(const Vec3& x) {
    for (int k = 0; k < 3; ++k) lower[k] = std::min(lower[k], x[k]), upper[k] = std::max(upper[k], x[k]);
  }
  // Whether some of a line from one point to another may lie inside.
  bool meets(const Vec3& from, const Vec3& to) const {
    double begin = 0, end = 1;
    for (int k = 0; k < 3; ++k) {
      const double step = to[k] - from[k], a = lower[k] - from[k], b = upper[k] - from[k];
      if (step == 0) {
        if (a > 0 || b < 0) return false;
        continue;
      }
      begin = std::max(begin, std::min(a / step, b / step));
      end = std::min(end, std::max(a / step, b / step));
    }
    return begin <= end;
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
