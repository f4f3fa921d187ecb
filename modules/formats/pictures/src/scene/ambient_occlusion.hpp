#pragma once

#include <vector>

namespace scree::pictures {

// Depths of the drawn pixels towards the viewer, in pixels, minus infinity where nothing is.
struct DepthField {
  int width = 0, height = 0;
  std::vector<float> depth{};
};

// Share of the light of an even sky that each pixel gets, 0 to 1: twice the part of a ball about the surface
// that is free of bodies, at most 1, so that an open plane has 1 and a right angle 1/2. Bodies are taken to
// fill what lies behind the surface, as in the volumetric obscurance of Loos and Sloan (2010); what stands
// more than one to three radii of the ball before it does not count. radius: of the ball (pixels).
std::vector<float> open_shares(const DepthField& field, double radius);

}  // namespace scree::pictures
