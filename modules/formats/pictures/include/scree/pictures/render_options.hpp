#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <scree/pictures/cut.hpp>

namespace scree::pictures {

inline constexpr std::array<std::string_view, 17> color_fields = {"radius",
                                                                  "speed",
                                                                  "velocity_x",
                                                                  "velocity_y",
                                                                  "velocity_z",
                                                                  "displacement",
                                                                  "displacement_x",
                                                                  "displacement_y",
                                                                  "displacement_z",
                                                                  "spin",
                                                                  "coordination",
                                                                  "pressure",
                                                                  "largest_force",
                                                                  "net_force",
                                                                  "material",
                                                                  "group",
                                                                  "id"};
// Maps by which surfaces may be coloured, see pictures::Surface.
inline constexpr std::array<std::string_view, 4> surface_maps_shown = {"none", "normal_stress",
                                                                       "shear_stress", "sliding_work"};
inline constexpr std::array<std::string_view, 4> view_names = {"iso", "x", "y", "z"};

// Options for drawing a frame.
struct RenderOptions {
  int width = 1200;                                  // (pixels) 200 to 8000
  int height = 900;                                  // (pixels) 200 to 8000
  std::string color_by = "radius";                   // one of color_fields; vectors are shown by magnitude
  std::string color_surfaces_by = "none";            // one of surface_maps_shown
  std::string view;                                  // one of view_names; empty: iso. In 2D always z
  std::optional<std::array<double, 3>> direction{};  // from the scene towards the viewer, instead of a view
  bool show_contacts = false;    // as bars; in 3D the spheres are drawn smaller so that the bars are visible
  bool strong_contacts = false;  // of these, the ones above the mean normal force alone, coloured by it
  bool show_bodies = true;
  bool show_walls = true;
  bool shadows = false;  // in 3D hollows between bodies are darker
  bool show_title = true, show_time = true;
  bool scale_bar = false;
  bool follow_bodies = false;  // the frame holds the bodies, and walls as far as they are in it
  // (m) only what lies between these ends along each axis; bodies are cut and closed there.
  Cut cut{};
  std::optional<std::array<double, 2>> color_range{};  // (SI unit of the field); absent: range in this frame
  double time_spacing =
      0;  // (s) between pictures; the time is shown to a hundredth of it, or with six digits if it is 0
};

}  // namespace scree::pictures
