#pragma once

#include "scene_camera.hpp"

#include <string>

class vtkRenderer;

namespace scree::pictures {

// Adds the walls: edges of all, translucent faces of those with their inner side towards the viewer.
// pixel_scale: drawn pixels per pixel of the picture. map: one of surface_maps_shown; facets where it is
// above 0 are opaque and coloured.
void add_walls(vtkRenderer* renderer, const Frame& frame, const SceneBox& box, const ViewAxes& axes,
               int pixel_scale, const std::string& map = "none");
// What the colours of facets mean; empty without a map. Throws Error if the frame does not have it.
std::string surface_note(const Frame& frame, const std::string& map);

}  // namespace scree::pictures
