#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace scree::snapshot {

inline constexpr std::array<std::string_view, 6> color_fields = {"radius",       "speed", "spin",
                                                                 "coordination", "force", "id"};
inline constexpr std::array<std::string_view, 4> view_names = {"iso", "x", "y", "z"};

// How a frame is drawn.
struct RenderOptions {
  int width = 1200;                 // (pixels) 200 to 8000
  int height = 900;                 // (pixels) 200 to 8000
  std::string color_by = "radius";  // one of color_fields; vectors by their magnitude
  std::string view;                 // one of view_names; empty: iso in 3D. In 2D always z, from above
  bool show_contacts = false;       // as bars; in 3D the spheres shrink, so that the bars are seen
  bool show_walls = true;
  std::optional<std::array<double, 2>> color_range{};  // (SI unit of the field); absent: range of this frame
};

}  // namespace scree::snapshot
