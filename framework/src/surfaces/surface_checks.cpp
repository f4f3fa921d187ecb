#include "surfaces/placed_surface.hpp"
#include "surfaces/triangle_mesh.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/particles.hpp>
#include <scree/surface_checks.hpp>

namespace scree {

namespace {

std::string text(const Vec3& v) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", v[0], v[1], v[2]); }

Vec3 centre(const Particles& p, std::size_t i) {
  Vec3 x = {};
  for (int k = 0; k < p.dimension(); ++k) x[k] = p.position()[k][i];
  return x;
}

// Throws Error if a mesh has no inside, though it is closed.
void check_inside(const PlacedSurface& surface, const std::string& name) {
  const auto refuse = [&](const char* what, const Vec3& where) {
    throw Error(
        fmt::format("surface {}: it {} at {} m, so that it has no inside; mend the file, or leave side out: "
                    "bodies then touch it from both sides",
                    name, what, text(surface.in_scene({where, {}, 0, {}}).point)));
  };
  if (const auto fold = surface.mesh()->fold()) refuse("folds back on itself", *fold);
  if (const auto crossing = surface.mesh()->crossing()) refuse("crosses itself", *crossing);
}

// Length (m) across all bodies and their largest diameter.
struct Extent {
  double across, diameter;

  explicit Extent(const Particles& p) : across(0), diameter(0) {
    Vec3 lower = p.size() > 0 ? centre(p, 0) : Vec3{}, upper = lower;
    for (std::size_t i = 0; i < p.size(); ++i) {
      diameter = std::max(diameter, 2 * p.radius()[i]);
      for (int k = 0; k < 3; ++k)
        lower[k] = std::min(lower[k], centre(p, i)[k]), upper[k] = std::max(upper[k], centre(p, i)[k]);
    }
    across = norm(upper - lower) + diameter;
  }
};

}  // namespace

std::vector<std::string> mesh_lines(const WallSurfaces& surfaces) {
  std::vector<std::string> lines;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (!surfaces.meshes[s]) continue;
    const TriangleMesh& mesh = *surfaces.meshes[s];
    const Vec3 at = PlacedSurface(surfaces, s, 3, 0).origin();
    const std::string found = mesh.findings().text();
    lines.push_back(fmt::format("{}: {} from {} to {} m, {}{}{}", surfaces.names[s],
                                counted(mesh.triangles().size(), "triangle"), text(at + mesh.bounds().lower),
                                text(at + mesh.bounds().upper), mesh.findings().closed() ? "closed" : "open",
                                found.empty() ? "" : "; ", found));
  }
  return lines;
}

// A mesh in mm that is read as one in m is a thousand times too large.
std::vector<std::string> mesh_warnings(const WallSurfaces& surfaces, const Particles& bodies) {
  constexpr double many_diameters = 5e3, many_packings = 200;
  std::vector<std::string> warnings;
  if (!surfaces.any_mesh() || bodies.size() == 0) return warnings;
  const Extent extent(bodies);
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (!surfaces.meshes[s]) continue;
    const double across = norm(surfaces.meshes[s]->bounds().upper - surfaces.meshes[s]->bounds().lower);
    const auto warn = [&](const char* what, double factor) {
      warnings.push_back(
          fmt::format("{} is {:.3g} m across and the largest body {:.3g} m, {}; if the unit of its file is "
                      "not m, give scale = {:g} for mm",
                      surfaces.names[s], across, extent.diameter, what, factor));
    };
    if (across > many_diameters * extent.diameter && across > many_packings * extent.across)
      warn("as if the file were in mm", 1e-3);
    else if (across < extent.diameter)
      warn("which does not fit", 1e-3);
  }
  return warnings;
}

void check_sides(const WallSurfaces& surfaces, const Particles& bodies) {
  const std::vector<PlacedSurface> placed = placed_surfaces(surfaces, bodies.dimension());
  for (std::size_t s = 0; s < placed.size(); ++s) {
    if (surfaces.shapes[s].side == SCREE_BOTH_SIDES || surfaces.absent[s]) continue;
    if (placed[s].mesh()) check_inside(placed[s], surfaces.names[s]);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!bodies.fixed.empty() && bodies.fixed[i]) continue;
      const NearestPoint nearest = placed[s].nearest(centre(bodies, i));
      if (nearest.distance < 0)
        throw Error(
            fmt::format("particle {}: its centre is {:.3g} m behind the surface {}; move it, or change the "
                        "side of the surface",
                        bodies.id[i], -nearest.distance, surfaces.names[s]));
    }
  }
}

}  // namespace scree
