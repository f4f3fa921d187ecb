#pragma once

#include <optional>

#include <scree/fields/averaging_kernel.hpp>
#include <scree/fields/field_grid.hpp>
#include <scree/fields/field_input.hpp>

namespace scree::fields {

// Which kernel and grid are wanted; what is not given follows from the scene.
struct GridRequest {
  KernelShape shape = KernelShape::triweight;
  double width = 0;                  // (m) of the kernel; 0: two mean diameters
  double spacing = 0;                // (m) from point to point; 0: half the width
  std::optional<Vec3> lower, upper;  // (m) corners of the box; default: the bodies, or the period
  int plane_axis = -1;               // of a grid of one layer; −1: none
  double plane = 0;                  // (m) where it is
};

// The kernel for an input. Throws Error if it has no bodies.
AveragingKernel kernel_for(const GridRequest& request, const FieldInput& input);

// The grid for an input; along each axis the spacing is made to fill the box with whole cells. Throws Error
// (place: "width", "spacing", "upper" or "plane", which is to be changed) if the box is empty, the grid is
// too large for the memory, too fine for the width, or far away.
FieldGrid grid_for(const GridRequest& request, const FieldInput& input);

}  // namespace scree::fields
