#pragma once

#include <array>
#include <string>

#include <scree/snapshot/frame.hpp>

class vtkRenderer;

namespace scree::snapshot {

using Point = std::array<double, 3>;

double dot(const Point& a, const Point& b);
Point cross(const Point& a, const Point& b);
Point normalised(const Point& a);
Point moved(const Point& from, double distance, const Point& direction);

// The part of space that a picture shows (m).
struct SceneBox {
  Point lower;
  Point upper;

  Point center() const;
  double diagonal() const;
  std::array<Point, 8> corners() const;
};

// The frame's box or, where it has none, that of its particles; grown so that near-by walls are within.
SceneBox scene_box(const Frame& frame);

// Unit vectors of the picture: to the right, up, and towards the eye.
struct ViewAxes {
  Point right;
  Point up;
  Point toward;
};

// x: from +x; y: from -y, so that x points right; z: from +z. Throws scree::Error for an unknown name.
ViewAxes view_axes(const std::string& view, int dimension);

// Orthographic: the box fits the panel.
struct SceneCamera {
  ViewAxes axes;
  Point center;        // (m) in the middle of the panel
  double half_height;  // (m) from there to the panel's upper edge
  double distance;     // (m) of the eye

  // aspect: width / height of the panel.
  static SceneCamera fitting(const SceneBox& box, const ViewAxes& axes, double aspect);

  // Sets the renderer's camera and lights.
  void apply(vtkRenderer* renderer) const;
};

}  // namespace scree::snapshot
