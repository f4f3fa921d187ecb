#include "surfaces/nearest_point.hpp"

#include "surfaces/shape_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace scree {

namespace {

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
  NearestPoint found;
  const auto find = [&](const auto& nearest) { found = nearest(x); };
  dimension == 2 ? shape::with_nearest<2>(surface, find) : shape::with_nearest<3>(surface, find);
  return found;
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
