#include "wall_outline.hpp"

#include <cmath>

namespace scree::pictures {
namespace {

// Sutherland-Hodgman step: the part of a convex polygon where normal . x >= offset.
std::vector<Point> clipped(const std::vector<Point>& polygon, const Point& normal, double offset) {
  std::vector<Point> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point& a = polygon[k];
    const Point& b = polygon[(k + 1) % polygon.size()];
    const double height_a = dot(normal, a) - offset;
    const double height_b = dot(normal, b) - offset;
    if (height_a >= 0) kept.push_back(a);
    if ((height_a < 0) == (height_b < 0)) continue;
    const double fraction = height_a / (height_a - height_b);
    kept.push_back(
        {std::lerp(a[0], b[0], fraction), std::lerp(a[1], b[1], fraction), std::lerp(a[2], b[2], fraction)});
  }
  return kept;
}

// Part of the plane around the box, larger than the box.
std::vector<Point> wide_patch(const Wall& wall, const SceneBox& box, int dimension) {
  const Point center = box.center();
  const double height = dot(wall.normal, moved(center, -1, wall.point));
  const Point foot = moved(center, -height, wall.normal);
  const double size = box.diagonal();
  if (dimension == 2) {
    const Point along = {-wall.normal[1], wall.normal[0], 0};
    return {moved(foot, -size, along), moved(foot, size, along)};
  }
  const Point helper = std::abs(wall.normal[2]) < 0.9 ? Point{0, 0, 1} : Point{1, 0, 0};
  const Point u = normalised(cross(helper, wall.normal));
  const Point v = cross(wall.normal, u);
  return {moved(moved(foot, -size, u), -size, v), moved(moved(foot, size, u), -size, v),
          moved(moved(foot, size, u), size, v), moved(moved(foot, -size, u), size, v)};
}

}  // namespace

std::vector<Point> wall_outline(const Frame& frame, std::size_t index, const SceneBox& box) {
  // The slack keeps walls that coincide with a face of the box or with each other.
  const double slack = 1e-6 * box.diagonal();
  std::vector<Point> outline = wide_patch(frame.walls[index], box, frame.dimension);
  for (int k = 0; k < frame.dimension; ++k) {
    Point axis{};
    axis[k] = 1;
    outline = clipped(outline, axis, box.lower[k] - slack);
    axis[k] = -1;
    outline = clipped(outline, axis, -box.upper[k] - slack);
  }
  for (std::size_t other = 0; other < frame.walls.size(); ++other)
    if (other != index)
      outline = clipped(outline, frame.walls[other].normal,
                        dot(frame.walls[other].normal, frame.walls[other].point) - slack);
  return outline;
}

}  // namespace scree::pictures
