#pragma once

#include "color_field.hpp"
#include "half_space.hpp"

#include <vector>

#include <scree/pictures/frame.hpp>

namespace scree::pictures {

// The frame, and the values of its field, with only those bodies of which a part lies in the half-spaces, and
// with the parts of contacts there.
Frame cut_frame(const Frame& frame, const std::vector<HalfSpace>& spaces, ColorField& field);

}  // namespace scree::pictures
