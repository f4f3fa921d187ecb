#include <algorithm>
#include <limits>

#include <scree/body_bounds.hpp>

namespace scree {

BodyBounds bounds_of(const std::vector<Body>& bodies, int dimension) {
  BodyBounds box;
  for (int k = 0; k < dimension && !bodies.empty(); ++k) {
    box.lower[k] = std::numeric_limits<double>::infinity();
    box.upper[k] = -box.lower[k];
    for (const Body& body : bodies) {
      box.lower[k] = std::min(box.lower[k], body.position[k] - body.radius);
      box.upper[k] = std::max(box.upper[k], body.position[k] + body.radius);
    }
  }
  return box;
}

}  // namespace scree
