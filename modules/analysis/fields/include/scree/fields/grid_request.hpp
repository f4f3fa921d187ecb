#pragma once

#include <optional>

#include <scree/fields/field_grid.hpp>
#include <scree/fields/field_input.hpp>

namespace scree::fields {

// Which grid is wanted; what is not given follows from the scene.
struct GridRequest {
  double width = 0;                  // (m) of the kernel; 0: two mean diameters
  double spacing = 0;                // (m) from point to point; 0: half the width
  std::optional<Vec3> lower, upper;  // (m) corners of the box; default: the bodies, or the period
  int plane_axis = -1;               // of a grid of one layer; −1: none
  double plane = 0;                  // (m) where it is
};

// (m) Two mean diameters of the bodies. Throws Error if there are none.
double default_width(const FieldInput& input);

// The grid for an input; along each axis the spacing is made to fill the box with whole cells. Throws Error
// (place: the name of the key) if the box is empty, or the grid too large for the memory or too fine for the
// width.
FieldGrid grid_for(const GridRequest& request, const FieldInput& input);

}  // namespace scree::fields
