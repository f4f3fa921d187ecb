#pragma once

#include "scene_camera.hpp"

#include <vector>

namespace scree::pictures {

// Indices of the particles visible in at least one pixel; in a dense packing these are few, and drawing only
// them saves time. width, height: of the panel in drawn pixels.
std::vector<std::size_t> visible_spheres(const Frame& frame, const SceneCamera& camera, int width,
                                         int height);

}  // namespace scree::pictures
