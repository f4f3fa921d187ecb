#pragma once

#include "color_field.hpp"
#include "half_space.hpp"

#include <vector>

class vtkRenderer;

namespace scree::pictures {

// What is left of spheres by planes, and how they are closed there.
struct SphereCut {
  std::vector<HalfSpace> spaces = {};  // in the coordinates (right, up, toward) from the eye
  double rim = 0;                      // (m) width of the dark edge of the faces
};

// Adds exact (ray-cast) spheres for the particles with the given indices, at `scale` times their radius.
void add_spheres(vtkRenderer* renderer, const Frame& frame, const ColorField& field,
                 const std::vector<std::size_t>& particles, double scale, const SphereCut& cut = {});

// Adds all particles as flat outlined discs, of which the parts in the half-spaces are drawn. pixel_scale:
// drawn pixels per pixel of the picture.
void add_discs(vtkRenderer* renderer, const Frame& frame, const ColorField& field, int pixel_scale,
               const std::vector<HalfSpace>& cut = {});

}  // namespace scree::pictures
