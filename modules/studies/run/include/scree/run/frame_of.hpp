#pragma once

#include <array>
#include <string>

#include <scree/pictures/frame.hpp>
#include <scree/simulation.hpp>

namespace scree::run {

// The part of space that a picture shows.
struct SceneBox {
  std::array<double, 3> lower{}, upper{};
};

// Box of a scene in its present state: bodies, axis-parallel walls and periodic domain.
SceneBox scene_box(const Simulation& simulation);

// What the next picture of a run shows: what the last one did, as long as it holds the scene and the scene
// fills it well; else the scene, with room on the sides where it has outgrown the box. `shown`: of the last
// picture; empty before the first.
SceneBox next_view(const SceneBox& shown, const SceneBox& scene);

// The current state of a simulation as a snapshot that shows the box. color_by: one of
// pictures::color_fields; displacements and groups are there only if it asks for them.
pictures::Frame frame_of(const Simulation& simulation, const std::string& title, const SceneBox& box,
                         const std::string& color_by = {});

}  // namespace scree::run
