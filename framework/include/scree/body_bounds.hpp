#pragma once

#include <vector>

#include <scree/particles.hpp>

namespace scree {

// Axis-aligned box around the surfaces of bodies (m).
struct BodyBounds {
  Vec3 lower = {}, upper = {};
};

// Bounding box of the bodies; zero at the origin without bodies. In 2D its z extent is 0.
BodyBounds bounds_of(const std::vector<Body>& bodies, int dimension);

}  // namespace scree
