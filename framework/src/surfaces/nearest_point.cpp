#include "surfaces/nearest_point.hpp"

#include "machine/instruction_levels.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace scree {

namespace {

// From a face with this normal at its outside, a signed height (m) and the curvatures that its outside has.
NearestPoint on_face(std::uint32_t side, const Vec3& point, const Vec3& outwards, double height,
                     const Vec2& curvature) {
  const bool inside = side == SCREE_INSIDE || (side == SCREE_BOTH_SIDES && height < 0);
  if (inside) return {point, -outwards, -height, -curvature};
  return {point, outwards, height, curvature};
}

// From a point of an edge; straight up if the centre lies on it.
NearestPoint on_edge(const Vec3& point, const Vec3& x) {
  const Vec3 away = x - point;
  const double distance = norm(away);
  return {point, distance > 0 ? 1 / distance * away : Vec3{{0, 0, 1}}, distance, {}};
}

NearestPoint on_flat(const scree_surface& s, int dimension, const Vec3& x) {
  const int up = dimension - 1;
  Vec3 point = {}, outwards = {};
  outwards[up] = 1;
  bool over_face = true;
  for (int k = 0; k < up; ++k) {
    point[k] = std::clamp(x[k], -s.size[k], s.size[k]);
    over_face = over_face && point[k] == x[k];
  }
  return over_face ? on_face(s.side, point, outwards, x[up], {}) : on_edge(point, x);
}

// In the half plane of the axis and x: distance from the axis, and z.
struct HalfPlane {
  Vec3 radial;  // unit
  double distance;

  explicit HalfPlane(const Vec3& x) : radial{{1, 0, 0}}, distance(std::sqrt(x[0] * x[0] + x[1] * x[1])) {
    if (distance > 0) radial = {{x[0] / distance, x[1] / distance, 0}};
  }
  Vec3 at(double radius, double z) const { return radius * radial + Vec3{{0, 0, z}}; }
};

NearestPoint on_revolved(const scree_surface& s, const Vec3& x) {
  const HalfPlane plane(x);
  const double r = s.size[0], z = s.size[1];
  if (std::isinf(z))
    return on_face(s.side, plane.at(r, x[2]), plane.radial, plane.distance - r, {{1 / r, 0}});
  const double along_r = s.size[2] - r, along_z = s.size[3] - z,
               length = std::sqrt(along_r * along_r + along_z * along_z);
  const double u_r = along_r / length, u_z = along_z / length;
  const double place = (plane.distance - r) * u_r + (x[2] - z) * u_z;
  if (place < 0) return on_edge(plane.at(r, z), x);
  if (place > length) return on_edge(plane.at(s.size[2], s.size[3]), x);
  const double radius = r + place * u_r, height = (plane.distance - r) * u_z - (x[2] - z) * u_r;
  // Of a cone across its lines; along them it is straight.
  const double curvature = radius > 0 ? u_z / radius : 0;
  return on_face(s.side, plane.at(radius, z + place * u_z), plane.at(u_z, -u_r), height, {{curvature, 0}});
}

// The edge at a height of a sphere or circle that is cut there.
NearestPoint on_rim(const scree_surface& s, int dimension, double height, const Vec3& x) {
  const double radius = std::sqrt(std::max(0.0, s.size[0] * s.size[0] - height * height));
  if (dimension == 2) return on_edge({{std::copysign(radius, x[0]), height, 0}}, x);
  return on_edge(HalfPlane(x).at(radius, height), x);
}

NearestPoint on_ball(const scree_surface& s, int dimension, const Vec3& x) {
  const int axis = dimension - 1;
  const double radius = s.size[0], distance = norm(x);
  const Vec3 outwards = distance > 0 ? 1 / distance * x : Vec3{{1, 0, 0}};
  const double height = radius * outwards[axis];
  if (height < s.size[1]) return on_rim(s, dimension, s.size[1], x);
  if (height > s.size[2]) return on_rim(s, dimension, s.size[2], x);
  return on_face(s.side, radius * outwards, outwards, distance - radius, {{1 / radius, 1 / radius}});
}

SCREE_EVERY_LEVEL_INLINED NearestPoint nearest_of_shape(const scree_surface& surface, int dimension,
                                                        const Vec3& x) {
  switch (surface.shape) {
    case SCREE_FLAT:
      return on_flat(surface, dimension, x);
    case SCREE_REVOLVED:
      return on_revolved(surface, x);
    default:
      return on_ball(surface, dimension, x);
  }
}

const char* problem_of_revolved(const scree_surface& s) {
  const auto [r0, z0, r1, z1] = s.size;
  if (!(r0 >= 0 && r1 >= 0 && std::isfinite(r0) && std::isfinite(r1) && r0 + r1 > 0))
    return "a radius is below 0, or both are 0";
  if (std::isnan(z0) || std::isnan(z1) || z1 < z0) return "its end lies below its start";
  if (std::isinf(z0) || std::isinf(z1))
    return std::isinf(z0) && std::isinf(z1) && z0 < z1 && r0 == r1 ? "" : "it is infinite at one end alone";
  return r0 != r1 || z0 != z1 ? "" : "its line has no length";
}

// TriangleMesh checks the numbers themselves.
const char* problem_of_mesh(const scree_surface& s, int dimension) {
  if (dimension == 2) return "a 2D scene has no meshes";
  if (!(s.size[0] > 0 && std::isfinite(s.size[0]))) return "its scale is not above 0";
  if (!(s.size[1] >= 0 && s.size[1] < std::numbers::pi / 2))
    return "its smooth angle is not below a right one";
  return s.mesh ? "" : "it has no triangles";
}

}  // namespace

NearestPoint nearest_point(const scree_surface& surface, int dimension, const Vec3& x) {
  return nearest_of_shape(surface, dimension, x);
}

const char* problem_of(const scree_surface& s, int dimension) {
  if (s.shape > SCREE_MESH || s.side > SCREE_INSIDE) return "its shape or side is unknown";
  if (s.shape == SCREE_MESH) return problem_of_mesh(s, dimension);
  if (s.shape == SCREE_REVOLVED)
    return dimension == 2 ? "a 2D scene has no such shape" : problem_of_revolved(s);
  if (s.shape == SCREE_BALL) {
    if (!(s.size[0] > 0 && std::isfinite(s.size[0]))) return "its radius is not above 0";
    return s.size[1] < s.size[2] && s.size[1] < s.size[0] && s.size[2] > -s.size[0]
               ? ""
               : "its limits leave nothing of it";
  }
  for (int k = 0; k < dimension - 1; ++k)
    if (!(s.size[k] > 0)) return "a length is not above 0";
  return "";
}

double reach_of(const scree_surface& s, int dimension) {
  switch (s.shape) {
    case SCREE_FLAT:
      return dimension == 2 ? s.size[0] : std::hypot(s.size[0], s.size[1]);
    case SCREE_REVOLVED:
      return std::max(std::hypot(s.size[0], s.size[1]), std::hypot(s.size[2], s.size[3]));
    default:
      return s.size[0];
  }
}

bool has_edges(const scree_surface& s, int dimension) {
  switch (s.shape) {
    case SCREE_FLAT:
      return !(std::isinf(s.size[0]) && (dimension == 2 || std::isinf(s.size[1])));
    case SCREE_REVOLVED:
      return !std::isinf(s.size[1]);
    default:
      return s.size[1] > -s.size[0] || s.size[2] < s.size[0];
  }
}

bool turns_into_itself(const scree_surface& s, int dimension) {
  if (s.shape == SCREE_MESH) return false;
  if (s.shape == SCREE_FLAT) return dimension == 3 && std::isinf(s.size[0]) && std::isinf(s.size[1]);
  return dimension == 3 || (std::isinf(s.size[1]) && std::isinf(s.size[2]));
}

}  // namespace scree
