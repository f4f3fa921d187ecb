#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <scree/plugin/abi.h>
#include <scree/plugin/rotation.hpp>

namespace scree {

class TriangleMesh;

// The surfaces of all boundaries, where their frames are and how they move.
struct WallSurfaces {
  std::vector<scree_surface> shapes;
  std::vector<std::shared_ptr<const TriangleMesh>> meshes;  // null of other shapes
  std::vector<scree_frame> frames;
  std::vector<scree_frame_load> loads;
  std::vector<std::uint32_t> materials;
  std::vector<std::string> names;    // "<boundary>.<surface>"
  std::vector<std::uint8_t> absent;  // exerts no forces
  std::vector<double> masses;        // (kg) see scree_boundary_instance; 0: forces do not move it

  std::size_t size() const { return shapes.size(); }
  bool any_mesh() const;
};

// From its axes to those of the scene.
inline Rotation rotation_of(const scree_frame& frame) {
  return {frame.orientation[0], {{frame.orientation[1], frame.orientation[2], frame.orientation[3]}}};
}

// "" or what a frame has that no surface can have: "velocity is (nan, 0, 0)".
std::string problem_of(const scree_frame& frame);

}  // namespace scree
