#pragma once

#include <string>

#include <scree/pictures/frame.hpp>

namespace scree::pictures {

// The content of a VTK XML PolyData file: valid XML with compressed binary arrays.
std::string particles_vtp(const Frame& frame);
std::string contacts_vtp(const Frame& frame);

}  // namespace scree::pictures
