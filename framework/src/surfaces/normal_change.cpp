#include "surfaces/normal_change.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace scree {

namespace {

// Sine of an angle that is round-off.
constexpr double round_off = 1e-12;

// Across the edges over which the body is; over the face S has the normal alone.
//   (1_S − n nᵀ)/d      S: the normal of the face and the axes along which the body is beyond it
Matrix3 of_flat(const scree_surface& s, int dimension, const Vec3& x, const NearestPoint& nearest) {
  const int up = dimension - 1;
  Matrix3 change = outer_square(-1 / nearest.distance, nearest.normal);
  change[std::size_t(up)][up] += 1 / nearest.distance;
  bool over_face = true;
  for (int k = 0; k < up; ++k) {
    if (std::abs(x[k]) <= s.size[k]) continue;
    change[std::size_t(k)][k] += 1 / nearest.distance;
    over_face = false;
  }
  return over_face ? Matrix3{} : change;
}

// Unit vectors from the axis to the body and around the axis; of a body on the axis 0.
struct AroundAxis {
  double distance;  // (m)
  Vec3 radial = {}, around = {};

  explicit AroundAxis(const Vec3& x) : distance(std::hypot(x[0], x[1])) {
    if (distance > 0) radial = {{x[0] / distance, x[1] / distance, 0}};
    around = {{-radial[1], radial[0], 0}};
  }
};

// Of a line or a point that is turned about the axis: around it the normal turns with the body, and in the
// plane of the axis about a point.
Matrix3 of_turned(const Vec3& x, const NearestPoint& nearest, bool about_point) {
  const AroundAxis axis(x);
  if (!(axis.distance > 0)) return {};
  Matrix3 change = outer_square(dot(nearest.normal, axis.radial) / axis.distance, axis.around);
  if (about_point) change += outer_square(1 / nearest.distance, cross(axis.around, nearest.normal));
  return change;
}

// Unit vector along the line of a revolved surface, towards its end.
Vec3 along_line(const scree_surface& s, const Vec3& x) {
  if (std::isinf(s.size[1])) return {{0, 0, 1}};
  const double r = s.size[2] - s.size[0], z = s.size[3] - s.size[1], length = std::hypot(r, z);
  return r / length * AroundAxis(x).radial + Vec3{{0, 0, z / length}};
}

Matrix3 of_revolved(const scree_surface& s, const Vec3& x, const NearestPoint& nearest) {
  return of_turned(x, nearest, std::abs(dot(nearest.normal, along_line(s, x))) > round_off);
}

Matrix3 of_ball(int dimension, const Vec3& x, const NearestPoint& nearest) {
  const bool on_face = nearest.curvature[0] != 0;
  if (on_face) return across((dot(nearest.normal, x) < 0 ? -1 : 1) / norm(x), nearest.normal);
  return dimension == 2 ? across(1 / nearest.distance, nearest.normal) : of_turned(x, nearest, true);
}

// Of a direction in 2D, which has no third component.
Matrix3 in_plane(Matrix3 change) {
  for (Vec3& row : change) row[2] = 0;
  change[2] = {};
  return change;
}

}  // namespace

Matrix3 normal_change(const scree_surface& surface, int dimension, const Vec3& x,
                      const NearestPoint& nearest) {
  switch (surface.shape) {
    case SCREE_FLAT:
      return of_flat(surface, dimension, x, nearest);
    case SCREE_REVOLVED:
      return of_revolved(surface, x, nearest);
    default:
      return dimension == 2 ? in_plane(of_ball(dimension, x, nearest)) : of_ball(dimension, x, nearest);
  }
}

Matrix3 normal_change(const TriangleMesh& mesh, const Vec3& x, const NearestPoint& spot) {
  const double distance = std::abs(spot.distance);
  std::vector<NearTriangle> near;
  mesh.triangles().find_near(x, distance * (1 + round_off) + mesh.tolerance(), near);
  Vec3 edge = {};
  for (const NearTriangle& n : near) {
    const Triangle& triangle = mesh.triangles()[n.triangle];
    const PointOnTriangle here = nearest_on(triangle, x);
    if (!(norm(here.point - spot.point) <= mesh.tolerance())) continue;
    if (norm(cross(triangle.normal, spot.normal)) < round_off) return {};
    const int e = int(here.part) - int(TrianglePart::edge_0);
    if (e < 0 || e > 2) continue;
    const Vec3 along = triangle.corner[(e + 1) % 3] - triangle.corner[e];
    edge = 1 / norm(along) * along;
  }
  Matrix3 change = across(1 / spot.distance, spot.normal);
  change += outer_square(-1 / spot.distance, edge);
  return change;
}

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

}  // namespace

Matrix3 normal_change_in_scene(const PlacedSurface& placed, int dimension, const Vec3& x,
                               const NearestPoint& nearest) {
  return turned(placed.to_scene(), placed.mesh() ? normal_change(*placed.mesh(), x, nearest)
                                                 : normal_change(placed.surface(), dimension, x, nearest));
}

Vec3 curvature_change(const scree_surface& surface, const Vec3& x, const NearestPoint& nearest) {
  if (surface.shape != SCREE_REVOLVED || nearest.curvature[0] == 0) return {};
  const Vec3 along = along_line(surface, x);
  const double radius = std::hypot(nearest.point[0], nearest.point[1]),
               widening = dot(along, AroundAxis(x).radial);
  return -nearest.curvature[0] / radius * widening * along;
}

}  // namespace scree
