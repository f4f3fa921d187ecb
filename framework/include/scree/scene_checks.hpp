#pragma once

#include <optional>
#include <string>
#include <vector>

#include <scree/domain.hpp>
#include <scree/scene.hpp>

namespace scree {

// Checks of parts of a scene before the scene is complete. All throw Error with the plug-in's own message.

// Number of planes and surfaces of all boundaries of a scene. Also throws if a boundary refuses to start.
std::size_t wall_count(const Scene& scene);
// Names of the planes of all boundaries, "<boundary>.<plane>", or of the surfaces.
std::vector<std::string> plane_names(const Scene& scene);
std::vector<std::string> surface_names(const Scene& scene);
// The periodic domain that the boundaries of a scene define together. Also throws if two boundaries define
// the same axis.
Domain periodic_domain(const Scene& scene);
// Whether the walls of a boundary of a scene follow one of its functions of time: with another control it has
// no effect.
bool has_effect(const Scene& scene, const Parameters& boundary, const std::string& program);
// The first function of time of a body force that varies, "gravity.acceleration_x"; none if all are constant.
std::optional<std::string> varying_body_force(const Scene& scene);
// Configures the body force and discards it.
void check_body_force(const Scene::BodyForce& force, const Scene& scene);

}  // namespace scree
