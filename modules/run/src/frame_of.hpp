#pragma once

#include <string>

#include <scree/simulation.hpp>
#include <scree/snapshot/frame.hpp>

namespace scree::run {

// The corners of a scene for the camera: bodies at the start, walls across the axes, periodic domain.
struct SceneBox {
  std::array<double, 3> lower{}, upper{};
};
SceneBox scene_box(const Simulation& simulation);

// What a snapshot shows of a simulation now.
snapshot::Frame frame_of(const Simulation& simulation, const std::string& title, const SceneBox& box);

}  // namespace scree::run
