#pragma once

#include "scene_camera.hpp"

class vtkRenderer;

namespace scree::snapshot {

// Adds the walls: translucent faces where the eye looks at their inner side, edges everywhere. pixel_scale:
// drawn pixels per pixel of the picture.
void add_walls(vtkRenderer* renderer, const Frame& frame, const SceneBox& box, const ViewAxes& axes,
               int pixel_scale);

}  // namespace scree::snapshot
