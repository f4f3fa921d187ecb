#include "surfaces/placed_surface.hpp"
#include "surfaces/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <scree/surface_outline.hpp>

namespace scree {

namespace {

using std::numbers::pi;

// Of a share of a whole turn, which ends where it began to the last bit.
double angle_of(double share) { return share < 1 ? 2 * pi * share : 0; }

constexpr std::uint32_t around = 72, along_ball = 24;  // cells of a whole turn, and from pole to pole

// Points by two parameters in [0, 1], of which the first may close a ring.
SurfaceOutline grid(std::uint32_t n, std::uint32_t m, const std::function<Vec3(double, double)>& point) {
  SurfaceOutline outline;
  for (std::uint32_t j = 0; j <= m; ++j)
    for (std::uint32_t i = 0; i <= n; ++i) outline.points.push_back(point(double(i) / n, double(j) / m));
  for (std::uint32_t j = 0; j < m; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, b = a + n + 1;
      outline.cells.insert(outline.cells.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  return outline;
}

// A line through points by a parameter in [0, 1].
void add_line(std::uint32_t n, const std::function<Vec3(double)>& point, SurfaceOutline& outline) {
  for (std::uint32_t i = 0; i <= n; ++i) {
    const auto at = std::uint32_t(outline.points.size());
    outline.points.push_back(point(double(i) / n));
    if (i > 0) outline.cells.insert(outline.cells.end(), {at - 1, at});
  }
}

// What is in view of an infinite line: its part within a radius (m) of the place nearest to the view.
struct View {
  Vec3 centre;  // in the frame of the surface
  double radius;

  double low(double end, int axis) const { return std::max(end, centre[axis] - radius); }
  double high(double end, int axis) const { return std::min(end, centre[axis] + radius); }
};

SurfaceOutline of_ball(const scree_surface& s, int dimension) {
  const double radius = s.size[0], from = std::acos(std::clamp(-s.size[1] / radius, -1.0, 1.0)),
               to = std::acos(std::clamp(-s.size[2] / radius, -1.0, 1.0));
  if (dimension == 3)
    return grid(around, along_ball, [&](double u, double v) {
      const double polar = from + v * (to - from), turn = angle_of(u);
      return radius *
             Vec3{{std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), -std::cos(polar)}};
    });
  SurfaceOutline outline;
  for (const double side : {-1.0, 1.0})
    add_line(
        around / 2,
        [&](double u) {
          const double polar = from + u * (to - from);
          return radius * Vec3{{side * std::sin(polar), -std::cos(polar), 0}};
        },
        outline);
  return outline;
}

SurfaceOutline of_shape(const scree_surface& s, int dimension, const View& view) {
  const double* const size = s.size;
  if (s.shape == SCREE_BALL) return of_ball(s, dimension);
  if (s.shape == SCREE_REVOLVED) {
    const bool infinite = std::isinf(size[1]);  // then its radii are equal
    const double low = infinite ? view.low(size[1], 2) : size[1],
                 high = infinite ? view.high(size[3], 2) : size[3];
    return grid(around, 1, [&](double u, double v) {
      const double radius = size[0] + v * (size[2] - size[0]);
      return Vec3{{radius * std::cos(angle_of(u)), radius * std::sin(angle_of(u)), low + v * (high - low)}};
    });
  }
  const auto place = [&](int axis, double u) {
    const bool infinite = std::isinf(size[axis]);
    const double low = infinite ? view.low(-size[axis], axis) : -size[axis],
                 high = infinite ? view.high(size[axis], axis) : size[axis];
    return low + u * (high - low);
  };
  if (dimension == 3)
    return grid(1, 1, [&](double u, double v) { return Vec3{{place(0, u), place(1, v), 0}}; });
  SurfaceOutline outline;
  add_line(
      1,
      [&](double u) {
        return Vec3{{place(0, u), 0, 0}};
      },
      outline);
  return outline;
}

SurfaceOutline of_mesh(const TriangleMesh& mesh) {
  SurfaceOutline outline;
  for (std::size_t t = 0; t < mesh.triangles().size(); ++t)
    for (const Vec3& corner : mesh.triangles()[t].corner) {
      outline.cells.push_back(std::uint32_t(outline.points.size()));
      outline.points.push_back(corner);
    }
  return outline;
}

}  // namespace

SurfaceOutline outline_of(const WallSurfaces& surfaces, std::size_t surface, int dimension, const Vec3& lower,
                          const Vec3& upper) {
  const PlacedSurface placed(surfaces, surface, dimension, 0);
  const View view = {placed.in_frame(0.5 * (lower + upper)), 0.5 * norm(upper - lower)};
  SurfaceOutline outline =
      placed.mesh() ? of_mesh(*placed.mesh()) : of_shape(surfaces.shapes[surface], dimension, view);
  for (Vec3& point : outline.points) point = placed.in_scene({point, {}, 0, {}}).point;
  return outline;
}

}  // namespace scree
