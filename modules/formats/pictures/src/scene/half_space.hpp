#pragma once

#include "scene_camera.hpp"

#include <vector>

#include <scree/pictures/cut.hpp>

namespace scree::pictures {

// The points x with normal . x >= offset (m); the normal is a unit vector.
struct HalfSpace {
  Point normal;
  double offset;
};

// What lies between the ends.
std::vector<HalfSpace> half_spaces(const Cut& cut);

// Whether a part of a sphere lies in all of them, or may, where two planes cut it.
bool reaches_into(const std::vector<HalfSpace>& spaces, const double* centre, double radius);

// The same in the coordinates (right, up, toward) of the picture, from the centre of the camera.
std::vector<HalfSpace> seen(const std::vector<HalfSpace>& spaces, const SceneCamera& camera);

// The part of a convex polygon, in 2D of a line between two points, that lies in the half-space.
std::vector<Point> clipped(const std::vector<Point>& polygon, const HalfSpace& space);

}  // namespace scree::pictures
