#pragma once

#include <scree/pictures/frame.hpp>

namespace scree::pictures {

// Throws scree::Error if a column has the wrong length or the dimension is neither 2 nor 3.
void check_columns(const Frame& frame);

// Throws scree::Error if a position, radius or normal force to be drawn is not finite.
void check_drawable(const Frame& frame);

}  // namespace scree::pictures
