#pragma once

#include "scene_camera.hpp"

#include <vector>

namespace scree::snapshot {

// Numbers of the particles that show in at least one pixel; in a dense packing few do, and only these need
// drawing. width, height: of the panel in drawn pixels.
std::vector<std::size_t> visible_spheres(const Frame& frame, const SceneCamera& camera, int width,
                                         int height);

}  // namespace scree::snapshot
