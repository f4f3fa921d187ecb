#include "scene_picture.hpp"

#include "ambient_occlusion.hpp"
#include "arrow_glyphs.hpp"
#include "contact_tubes.hpp"
#include "cut_frame.hpp"
#include "files/frame_check.hpp"
#include "panel.hpp"
#include "particle_actors.hpp"
#include "scene_camera.hpp"
#include "sphere_visibility.hpp"
#include "wall_actors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <fmt/format.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace scree::pictures {
namespace {

// Spheres of full size would hide the contacts between them.
constexpr double sphere_scale_among_contacts = 0.4;
constexpr double sphere_scale_among_arrows = 0.15;

bool shrinks_spheres(const Frame& frame, const RenderOptions& options) {
  return options.show_contacts && options.show_bodies && frame.dimension == 3;
}

// Pictures are taken at steps, whose times need not be multiples of the spacing.
std::string time_text(double time, double spacing) {
  if (!(spacing > 0)) return fmt::format("{:.6g}", time);
  // Three digits of the spacing, and of a time that is shorter.
  const double shown = time > 0 ? std::min(time, spacing) : spacing;
  const double unit = std::pow(10.0, std::floor(std::log10(shown) + 1e-9) - 2);
  return fmt::format("{:.12g}", std::round(time / unit) * unit);
}

// The largest of 1, 2 and 5 times a power of ten that is not above a length (m).
double round_length(double longest) {
  const double power = std::pow(10.0, std::floor(std::log10(longest)));
  return power * (longest >= 5 * power ? 5 : longest >= 2 * power ? 2 : 1);
}

void add_panel(vtkRenderer* renderer, Panel* panel) {
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->SetRenderer(renderer);
  actor->GetScene()->AddItem(panel);
  renderer->AddActor(actor);
}

vtkNew<Panel> make_panel(const Frame& frame, const RenderOptions& options, const SceneLayout& layout,
                         const SceneCamera& camera) {
  vtkNew<Panel> panel;
  panel->layout = layout;
  panel->axes = camera.axes;
  if (options.show_title) panel->title = frame.title;
  if (options.show_time) panel->time = fmt::format("t = {} s", time_text(frame.time, options.time_spacing));
  panel->pixels_per_metre = layout.scene_height() / (2 * camera.half_height);
  if (options.scale_bar)
    panel->scale_bar = round_length(0.25 * layout.scene_width() / panel->pixels_per_metre);
  if (options.show_contacts) panel->note = contact_note(frame, options.strong_contacts);
  if (shrinks_spheres(frame, options))
    panel->note =
        fmt::format("spheres: at {:g} of their radius; {}", sphere_scale_among_contacts, panel->note);
  if (const std::string surfaces = surface_note(frame, options.color_surfaces_by); !surfaces.empty())
    panel->note = panel->note.empty() ? surfaces : panel->note + "; " + surfaces;
  return panel;
}

// From the eye, with edges as wide as the rims of discs.
SphereCut cut_of_spheres(std::vector<HalfSpace> spaces, const SceneCamera& camera,
                         const SceneLayout& layout) {
  for (HalfSpace& space : spaces) space.offset -= space.normal[2] * camera.distance;
  return {std::move(spaces), 1.25 * layout.pixel_scale * 2 * camera.half_height / layout.scene_height()};
}

void add_particles(vtkRenderer* renderer, const Frame& frame, const RenderOptions& options,
                   const ColorField& field, const SceneCamera& camera, const SceneLayout& layout,
                   DepthMemory& memory) {
  if (frame.particle_count() == 0 || !options.show_bodies) return;
  const std::vector<HalfSpace> cut = half_spaces(options.cut);
  if (frame.dimension == 2) return add_discs(renderer, frame, field, layout.pixel_scale, cut);
  const std::vector<HalfSpace> cut_in_view = seen(cut, camera);
  std::vector<std::size_t> particles(frame.particle_count());
  std::iota(particles.begin(), particles.end(), std::size_t{0});
  const SphereCut sphere_cut = cut_of_spheres(cut_in_view, camera, layout);
  if (shrinks_spheres(frame, options))
    return add_spheres(renderer, frame, field, particles, sphere_scale_among_contacts, sphere_cut);
  particles = visible_spheres(frame, camera, int(std::lround(layout.scene_width())),
                              int(std::lround(layout.scene_height())), cut_in_view, memory);
  add_spheres(renderer, frame, field, particles, 1, sphere_cut);
}

// Bodies among their arrows: small and of one pale grey.
ColorField pale_bodies(const Frame& frame) {
  const std::vector<double> none(frame.particle_count(), std::numeric_limits<double>::quiet_NaN());
  return {.title = "", .values = none, .lower = 0, .upper = 1, .whole_numbers = false, .paleness = 0.5};
}

void add_bodies_with_arrows(vtkRenderer* renderer, const Frame& frame, const ArrowField& arrows,
                            const ColorField& lengths, const SceneLayout& layout) {
  const ColorField pale = pale_bodies(frame);
  std::vector<std::size_t> particles(frame.particle_count());
  std::iota(particles.begin(), particles.end(), std::size_t{0});
  if (frame.dimension == 2)
    add_discs(renderer, frame, pale, layout.pixel_scale);
  else if (!particles.empty())
    add_spheres(renderer, frame, pale, particles, sphere_scale_among_arrows);
  add_arrows(renderer, frame, arrows, lengths);
}

// Black where hollows are, more opaque the less open they are.
vtkSmartPointer<vtkImageData> shade_of(const DepthField& field, double radius) {
  // Above 1, for a difference that is seen.
  constexpr float contrast = 1.5f;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(field.width, field.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* pixel = static_cast<std::uint8_t*>(image->GetScalarPointer());
  for (const float share : open_shares(field, radius)) {
    std::fill_n(pixel, 3, std::uint8_t{0});
    pixel[3] = std::uint8_t(std::lround(255 * (1 - std::pow(share, contrast))));
    pixel += 4;
  }
  return image;
}

// The ball has the mean size of the bodies, so that hollows between neighbours are dark.
Hollows hollows_of(const Frame& frame, const SceneCamera& camera, const SceneLayout& layout) {
  const double pixels_per_metre = layout.scene_height() / (2 * camera.half_height);
  const double mean = frame.radius.empty() ? 0
                                           : std::accumulate(frame.radius.begin(), frame.radius.end(), 0.0) /
                                                 double(frame.particle_count());
  return {.left = 0,
          .bottom = int(std::lround(layout.note())),
          .width = int(layout.scene_width()),
          .height = int(layout.scene_height()),
          .depth_range = pixels_per_metre * camera.depth_range(),
          .radius = std::clamp(2 * pixels_per_metre * mean, 3.0, 200.0)};
}

// arrows: null without them.
Picture picture_of(OffscreenContext& context, const Frame& whole, const ArrowField* arrows,
                   const RenderOptions& options) {
  check_size(options.width, options.height);
  check_columns(whole);
  check_drawable(whole);
  ColorField field = arrows ? arrow_lengths(whole, *arrows) : color_field(whole, options);
  const std::vector<HalfSpace> spaces = arrows ? std::vector<HalfSpace>() : half_spaces(options.cut);
  const Frame part = spaces.empty() ? Frame() : cut_frame(whole, spaces, field);
  const Frame& frame = spaces.empty() ? whole : part;
  const ViewAxes axes = options.direction && frame.dimension == 3 ? axes_towards(*options.direction)
                                                                  : view_axes(options.view, frame.dimension);
  const SceneBox box = options.follow_bodies && frame.particle_count() > 0
                           ? box_of_bodies(frame, arrows ? Cut() : options.cut)
                           : scene_box(frame);
  const SceneLayout layout = SceneLayout::of_size(options.width, options.height, options.scale_bar);

  vtkNew<vtkRenderer> scene, overlay;
  scene->SetBackground(1, 1, 1);
  // By default VTK gathers translucent colours in frame buffers of floats, for any order. Walls have one
  // colour, so that their order does not matter.
  const vtkNew<vtkRenderStepsPass> steps;
  scene->SetPass(steps);
  scene->SetViewport(0, layout.note() / layout.height, layout.scene_width() / layout.width,
                     1 - layout.caption() / layout.height);
  const auto camera = SceneCamera::fitting(box, axes, layout.scene_width() / layout.scene_height());
  if (arrows)
    add_bodies_with_arrows(scene, frame, *arrows, field, layout);
  else
    add_particles(scene, frame, options, field, camera, layout, context.depth_memory);
  if (options.show_contacts) add_contacts(scene, frame, options.strong_contacts);
  if (options.show_walls) add_walls(scene, frame, box, axes, layout.pixel_scale, options.color_surfaces_by);
  camera.apply(scene);

  vtkNew<vtkRenderer> background;  // white behind the parts outside the panel of the scene
  background->SetBackground(1, 1, 1);
  vtkNew<Panel> panel = make_panel(frame, options, layout, camera);
  if (arrows) panel->note = arrows->note;
  if (frame.particle_count() > 0 && options.show_bodies) panel->field = &field;
  add_panel(overlay, panel);
  if (options.shadows && !arrows && frame.dimension == 3) {
    const Hollows hollows = hollows_of(frame, camera, layout);
    panel->shade = shade_of(context.draw_depths(options.width, options.height, {background, scene}, hollows),
                            hollows.radius);
    overlay->EraseOff();
    return context.draw(options.width, options.height, {overlay});
  }
  return context.draw(options.width, options.height, {background, scene, overlay});
}

}  // namespace

Picture scene_picture(OffscreenContext& context, const Frame& frame, const RenderOptions& options) {
  return picture_of(context, frame, nullptr, options);
}

Picture arrow_picture(OffscreenContext& context, const Frame& frame, const ArrowField& arrows,
                      const RenderOptions& options) {
  return picture_of(context, frame, &arrows, options);
}

}  // namespace scree::pictures
