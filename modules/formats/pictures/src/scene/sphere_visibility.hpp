#pragma once

#include "half_space.hpp"

#include <vector>

namespace scree::pictures {

// Depth and sphere of each pixel. A caller keeps it from picture to picture, which spares page faults.
struct DepthMemory {
  std::vector<float> depth{};
  std::vector<int> owner{};
};

// Indices of the particles visible in at least one pixel; in a dense packing these are few, and drawing only
// them saves time. width, height: of the panel in drawn pixels; cut: what is drawn, as seen().
std::vector<std::size_t> visible_spheres(const Frame& frame, const SceneCamera& camera, int width, int height,
                                         const std::vector<HalfSpace>& cut, DepthMemory& memory);

}  // namespace scree::pictures
