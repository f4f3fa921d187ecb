#pragma once

#include "scene_camera.hpp"

class vtkRenderer;

namespace scree::pictures {

// Adds the walls: edges of all, translucent faces of those with their inner side towards the viewer.
// pixel_scale: drawn pixels per pixel of the picture.
void add_walls(vtkRenderer* renderer, const Frame& frame, const SceneBox& box, const ViewAxes& axes,
               int pixel_scale);

}  // namespace scree::pictures
