#pragma once

#include <array>
#include <optional>

#include <scree/pictures/frame.hpp>

namespace scree::pictures {

// The frame with only those bodies whose centre lies between the ends along each axis (m), and with contacts
// that have both ends there. Throws scree::Error if no body is left.
Frame cut_frame(const Frame& frame, const std::array<std::optional<std::array<double, 2>>, 3>& cut);

}  // namespace scree::pictures
