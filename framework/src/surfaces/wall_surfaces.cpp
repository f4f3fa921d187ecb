#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/wall_surfaces.hpp>

namespace scree {

bool WallSurfaces::any_mesh() const {
  return std::any_of(meshes.begin(), meshes.end(), [](const auto& mesh) { return mesh != nullptr; });
}

std::string problem_of(const scree_frame& frame) {
  const auto bad = [](const char* name, const double(&v)[3]) -> std::string {
    for (const double x : v)
      if (!std::isfinite(x)) return fmt::format("{} is ({:g}, {:g}, {:g})", name, v[0], v[1], v[2]);
    return "";
  };
  for (const std::string& text :
       {bad("position", frame.position), bad("velocity", frame.velocity), bad("spin", frame.spin),
        bad("velocity", frame.mid_velocity), bad("spin", frame.mid_spin)})
    if (!text.empty()) return text;
  double square = 0;
  for (const double q : frame.orientation) square += q * q;
  // Round-off of many turns, with a margin.
  return std::abs(square - 1) < 1e-9 ? "" : fmt::format("orientation has length {:g}", std::sqrt(square));
}

}  // namespace scree
