#include "half_space.hpp"

#include <algorithm>
#include <cmath>

namespace scree::pictures {

std::vector<HalfSpace> half_spaces(const Cut& cut) {
  std::vector<HalfSpace> spaces;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!cut[k]) continue;
    Point axis{};
    axis[k] = 1;
    spaces.push_back({axis, (*cut[k])[0]});
    axis[k] = -1;
    spaces.push_back({axis, -(*cut[k])[1]});
  }
  return spaces;
}

bool reaches_into(const std::vector<HalfSpace>& spaces, const double* centre, double radius) {
  const Point point = {centre[0], centre[1], centre[2]};
  return std::all_of(spaces.begin(), spaces.end(), [&](const HalfSpace& space) {
    return dot(space.normal, point) + radius > space.offset;
  });
}

std::vector<HalfSpace> seen(const std::vector<HalfSpace>& spaces, const SceneCamera& camera) {
  std::vector<HalfSpace> result;
  const ViewAxes& axes = camera.axes;
  for (const auto& [normal, offset] : spaces)
    result.push_back({{dot(normal, axes.right), dot(normal, axes.up), dot(normal, axes.toward)},
                      offset - dot(normal, camera.center)});
  return result;
}

// A step of the algorithm of Sutherland and Hodgman.
std::vector<Point> clipped(const std::vector<Point>& polygon, const HalfSpace& space) {
  std::vector<Point> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point& a = polygon[k];
    const Point& b = polygon[(k + 1) % polygon.size()];
    const double height_a = dot(space.normal, a) - space.offset;
    const double height_b = dot(space.normal, b) - space.offset;
    if (height_a >= 0) kept.push_back(a);
    if ((height_a < 0) == (height_b < 0)) continue;
    const double fraction = height_a / (height_a - height_b);
    kept.push_back(
        {std::lerp(a[0], b[0], fraction), std::lerp(a[1], b[1], fraction), std::lerp(a[2], b[2], fraction)});
  }
  return kept;
}

}  // namespace scree::pictures
