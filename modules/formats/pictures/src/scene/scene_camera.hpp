#pragma once

#include "point.hpp"

#include <array>
#include <optional>
#include <string>

#include <scree/pictures/frame.hpp>

class vtkRenderer;

namespace scree::pictures {

inline constexpr int scene_lights = 2;  // each from one direction

// Ends along each axis (m), absent: none.
using Cut = std::array<std::optional<std::array<double, 2>>, 3>;

// Region that a picture shows (m).
struct SceneBox {
  Point lower;
  Point upper;

  Point center() const;
  double diagonal() const;
  std::array<Point, 8> corners() const;
};

// The box of the frame, or of its particles if it has none, enlarged to include near-by walls.
SceneBox scene_box(const Frame& frame);
// The box of its particles with a margin, as far as the cut leaves it.
SceneBox box_of_bodies(const Frame& frame, const Cut& cut);

// Unit vectors of the picture: right, up, and towards the viewer.
struct ViewAxes {
  Point right;
  Point up;
  Point toward;
};

// x: from +x; y: from -y, so that x points right; z: from +z. Throws scree::Error for an unknown name.
ViewAxes view_axes(const std::string& view, int dimension);
// From a direction towards the viewer, with z upwards in the picture. Throws scree::Error for a zero vector.
ViewAxes axes_towards(const Point& direction);

// Orthographic: the box fits the panel.
struct SceneCamera {
  ViewAxes axes;
  Point center;        // (m) in the middle of the panel
  double half_height;  // (m) from the centre to the upper edge of the panel
  double distance;     // (m) of the camera from the centre

  // aspect: width / height of the panel.
  static SceneCamera fitting(const SceneBox& box, const ViewAxes& axes, double aspect);

  // Between the nearest and the farthest depth that is drawn (m).
  double depth_range() const { return distance; }
  // Sets camera and lights of the renderer.
  void apply(vtkRenderer* renderer) const;
};

}  // namespace scree::pictures
