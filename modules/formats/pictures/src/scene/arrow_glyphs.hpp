#pragma once

#include "color_field.hpp"

#include <scree/pictures/arrow_field.hpp>

class vtkRenderer;

namespace scree::pictures {

// Length of each arrow over the longest. Throws scree::Error if there is not one finite arrow per
// particle.
ColorField arrow_lengths(const Frame& frame, const ArrowField& arrows);

// Adds the arrows but those that are too short to be seen.
void add_arrows(vtkRenderer* renderer, const Frame& frame, const ArrowField& arrows,
                const ColorField& lengths);

}  // namespace scree::pictures
