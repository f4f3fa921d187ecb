#include "plugins/body_forces.hpp"
#include "plugins/boundaries.hpp"

#include <scree/scene_checks.hpp>

namespace scree {

std::size_t plane_count(const Scene& scene) { return boundaries_of(scene).planes().size(); }

Domain periodic_domain(const Scene& scene) { return boundaries_of(scene).domain(); }

bool is_still(const Scene& scene, const Parameters& boundary) {
  const BodyBounds bodies = bounds_of(scene.bodies, scene.dimension);
  return ConfiguredBoundary(boundary, scene.dimension, bodies.lower.component, bodies.upper.component)
      .instance()
      .still;
}

void check_body_force(const Scene::BodyForce& force, const Scene& scene) {
  BodyForces({force}, scene.dimension, scene.audit);
}

}  // namespace scree
