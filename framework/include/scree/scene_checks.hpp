#pragma once

#include <scree/domain.hpp>
#include <scree/scene.hpp>

namespace scree {

// Checks of parts of a scene before all of it is known. All throw Error with the plug-in's own message.

// How many planes a boundary has in a scene of these bodies.
std::size_t plane_count(const Scene::Boundary& boundary, const Scene& scene);
// The periodic axes that the boundaries of a scene make together. Throws also if two make the same axis
// periodic.
Domain periodic_domain(const Scene& scene);
void check_body_force(const Scene::BodyForce& force, const Scene& scene);

}  // namespace scree
