#include "scene_picture.hpp"

#include "contact_tubes.hpp"
#include "frame_check.hpp"
#include "panel.hpp"
#include "particle_actors.hpp"
#include "scene_camera.hpp"
#include "sphere_visibility.hpp"
#include "wall_actors.hpp"

#include <cmath>
#include <numeric>
#include <vector>

#include <fmt/format.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

namespace scree::snapshot {
namespace {

// Spheres of full size would hide the contacts between them.
constexpr double sphere_scale_among_contacts = 0.4;

bool shrinks_spheres(const Frame& frame, const RenderOptions& options) {
  return options.show_contacts && frame.dimension == 3;
}

void add_panel(vtkRenderer* renderer, Panel* panel) {
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->SetRenderer(renderer);
  actor->GetScene()->AddItem(panel);
  renderer->AddActor(actor);
}

vtkNew<Panel> make_panel(const Frame& frame, const RenderOptions& options, const SceneLayout& layout,
                         const ViewAxes& axes) {
  vtkNew<Panel> panel;
  panel->layout = layout;
  panel->axes = axes;
  panel->title = frame.title;
  panel->time = fmt::format("t = {:.6g} s", frame.time);
  if (options.show_contacts) panel->note = contact_note(frame);
  if (shrinks_spheres(frame, options))
    panel->note =
        fmt::format("spheres: at {:g} of their radius; {}", sphere_scale_among_contacts, panel->note);
  return panel;
}

void add_particles(vtkRenderer* renderer, const Frame& frame, const RenderOptions& options,
                   const ColorField& field, const SceneCamera& camera, const SceneLayout& layout) {
  if (frame.particle_count() == 0) return;
  if (frame.dimension == 2) return add_discs(renderer, frame, field, layout.pixel_scale);
  std::vector<std::size_t> particles(frame.particle_count());
  std::iota(particles.begin(), particles.end(), std::size_t{0});
  if (shrinks_spheres(frame, options))
    return add_spheres(renderer, frame, field, particles, sphere_scale_among_contacts);
  particles = visible_spheres(frame, camera, int(std::lround(layout.scene_width())),
                              int(std::lround(layout.scene_height())));
  add_spheres(renderer, frame, field, particles, 1);
}

}  // namespace

Picture scene_picture(OffscreenContext& context, const Frame& frame, const RenderOptions& options) {
  check_size(options.width, options.height);
  check_columns(frame);
  check_drawable(frame);
  const ColorField field = color_field(frame, options);
  const ViewAxes axes = view_axes(options.view, frame.dimension);
  const SceneBox box = scene_box(frame);
  const SceneLayout layout = SceneLayout::of_size(options.width, options.height);

  vtkNew<vtkRenderer> scene, overlay;
  scene->SetBackground(1, 1, 1);
  scene->SetViewport(0, layout.note() / layout.height, layout.scene_width() / layout.width,
                     1 - layout.caption() / layout.height);
  const auto camera = SceneCamera::fitting(box, axes, layout.scene_width() / layout.scene_height());
  add_particles(scene, frame, options, field, camera, layout);
  if (options.show_contacts) add_contacts(scene, frame);
  if (options.show_walls) add_walls(scene, frame, box, axes, layout.pixel_scale);
  camera.apply(scene);

  vtkNew<vtkRenderer> background;  // white behind the parts outside the panel of the scene
  background->SetBackground(1, 1, 1);
  vtkNew<Panel> panel = make_panel(frame, options, layout, axes);
  if (frame.particle_count() > 0) panel->field = &field;
  add_panel(overlay, panel);
  return context.draw(options.width, options.height, {background, scene, overlay});
}

}  // namespace scree::snapshot
