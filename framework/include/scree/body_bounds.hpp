#pragma once

#include <vector>

#include <scree/particles.hpp>

namespace scree {

// Box around the surfaces of bodies. (m)
struct BodyBounds {
  Vec3 lower = {}, upper = {};
};

// Shrunk to the origin without bodies; z is 0 in two dimensions.
BodyBounds bounds_of(const std::vector<Body>& bodies, int dimension);

}  // namespace scree
