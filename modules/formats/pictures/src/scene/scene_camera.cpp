#include "scene_camera.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <scree/error.hpp>
#include <scree/pictures/render_options.hpp>

namespace scree::pictures {
namespace {

SceneBox particle_box(const Frame& frame) {
  if (frame.radius.empty()) return {{0, 0, 0}, {1, 1, 1}};
  SceneBox box{{frame.position[0], frame.position[1], frame.position[2]},
               {frame.position[0], frame.position[1], frame.position[2]}};
  for (std::size_t i = 0; i < frame.radius.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      box.lower[k] = std::min(box.lower[k], frame.position[3 * i + k] - frame.radius[i]);
      box.upper[k] = std::max(box.upper[k], frame.position[3 * i + k] + frame.radius[i]);
    }
  return box;
}

// Grows the box to a wall outside it, such as a raised lid, along the axis nearest to the normal of the wall.
void grow_to_wall(SceneBox& box, const Wall& wall, double reach) {
  double gap = reach;
  for (const Point& corner : box.corners())
    gap = std::min(gap, dot(wall.normal, moved(corner, -1, wall.point)));
  if (gap <= 0 || gap >= reach) return;
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(wall.normal[k]) > std::abs(wall.normal[axis])) axis = k;
  const double shift = gap / wall.normal[axis];
  (shift > 0 ? box.lower : box.upper)[axis] -= shift;
}

void add_light(vtkRenderer* renderer, const Point& position, double intensity) {
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(position[0], position[1], position[2]);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  renderer->AddLight(light);
}

}  // namespace

Point SceneBox::center() const {
  return {(lower[0] + upper[0]) / 2, (lower[1] + upper[1]) / 2, (lower[2] + upper[2]) / 2};
}

double SceneBox::diagonal() const {
  return std::hypot(upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]);
}

std::array<Point, 8> SceneBox::corners() const {
  std::array<Point, 8> corners;
  for (int corner = 0; corner < 8; ++corner)
    for (int k = 0; k < 3; ++k) corners[corner][k] = (corner >> k & 1) ? upper[k] : lower[k];
  return corners;
}

SceneBox scene_box(const Frame& frame) {
  bool given = true;
  for (int k = 0; k < frame.dimension; ++k) given = given && frame.lower[k] < frame.upper[k];
  SceneBox box = given ? SceneBox{frame.lower, frame.upper} : particle_box(frame);
  if (frame.dimension == 2) box.lower[2] = box.upper[2] = 0;
  const double reach = box.diagonal();
  for (const Wall& wall : frame.walls) grow_to_wall(box, wall, reach);
  return box;
}

SceneBox box_of_bodies(const Frame& frame, const Cut& cut) {
  constexpr double margin = 0.03;
  SceneBox box = particle_box(frame);
  const double room = margin * box.diagonal();
  for (int k = 0; k < frame.dimension; ++k) {
    box.lower[k] -= room;
    box.upper[k] += room;
    if (!cut[k]) continue;
    box.lower[k] = std::max(box.lower[k], (*cut[k])[0]);
    box.upper[k] = std::min(box.upper[k], (*cut[k])[1]);
  }
  if (frame.dimension == 2) box.lower[2] = box.upper[2] = 0;
  return box;
}

ViewAxes view_axes(const std::string& view, int dimension) {
  if (!view.empty() && std::find(view_names.begin(), view_names.end(), view) == view_names.end())
    throw Error(
        fmt::format("view: unknown view \"{}\"; choose one of {}", view, fmt::join(view_names, ", ")));
  if (dimension == 2 || view == "z") return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  if (view == "x") return {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  if (view == "y") return {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
  return axes_towards({0.55, -1, 0.5});
}

ViewAxes axes_towards(const Point& direction) {
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  if (!(length > 0) || !std::isfinite(length))
    throw Error("view: the direction towards the viewer has no length; give one such as [1, -1, 0.5]");
  // By a power of 2, so that squares stay in the range of numbers.
  Point scaled = direction;
  for (double& component : scaled) component = std::scalbn(component, -std::ilogb(length));
  const Point toward = normalised(scaled);
  const bool from_above = std::hypot(toward[0], toward[1]) < 1e-9;
  const Point right = from_above ? Point{1, 0, 0} : normalised(cross({0, 0, 1}, toward));
  return {right, cross(toward, right), toward};
}

SceneCamera SceneCamera::fitting(const SceneBox& box, const ViewAxes& axes, double aspect) {
  SceneCamera camera{axes, box.center(), 0, 2 * box.diagonal()};
  for (const Point& corner : box.corners()) {
    const Point offset = moved(corner, -1, camera.center);
    const double needed =
        std::max(std::abs(dot(offset, axes.up)), std::abs(dot(offset, axes.right)) / aspect);
    camera.half_height = std::max(camera.half_height, 1.04 * needed);
  }
  return camera;
}

void SceneCamera::apply(vtkRenderer* renderer) const {
  const Point eye = moved(center, distance, axes.toward);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(center.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(axes.up.data());
  camera->SetParallelScale(half_height);
  camera->SetClippingRange(0.5 * distance, 1.5 * distance);
  renderer->AutomaticLightCreationOff();
  add_light(renderer, {-0.6, 0.8, 1}, 0.7);
  add_light(renderer, {0, 0, 1}, 0.45);
}

}  // namespace scree::pictures
