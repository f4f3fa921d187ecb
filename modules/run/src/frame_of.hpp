#pragma once

#include <string>

#include <scree/simulation.hpp>
#include <scree/snapshot/frame.hpp>

namespace scree::run {

// Box of a scene for the camera: bodies at the start, axis-parallel walls and periodic domain.
struct SceneBox {
  std::array<double, 3> lower{}, upper{};
};
SceneBox scene_box(const Simulation& simulation);

// The current state of a simulation as a snapshot.
snapshot::Frame frame_of(const Simulation& simulation, const std::string& title, const SceneBox& box);

}  // namespace scree::run
