#pragma once

#include "scene_camera.hpp"

#include <vector>

namespace scree::pictures {

// Corners of the part of wall number `index` that lies within the box and on the inner side of the other
// walls: a polygon in 3D, the two ends of a line (possibly repeated) in 2D, empty if no part does.
std::vector<Point> wall_outline(const Frame& frame, std::size_t index, const SceneBox& box);

}  // namespace scree::pictures
