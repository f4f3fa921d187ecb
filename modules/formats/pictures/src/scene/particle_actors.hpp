#pragma once

#include "color_field.hpp"

#include <vector>

class vtkRenderer;

namespace scree::pictures {

// Adds exact (ray-cast) spheres for the particles with the given indices, at `scale` times their radius.
void add_spheres(vtkRenderer* renderer, const Frame& frame, const ColorField& field,
                 const std::vector<std::size_t>& particles, double scale);

// Adds all particles as flat outlined discs. pixel_scale: drawn pixels per pixel of the picture.
void add_discs(vtkRenderer* renderer, const Frame& frame, const ColorField& field, int pixel_scale);

}  // namespace scree::pictures
