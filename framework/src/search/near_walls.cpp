#include "search/near_walls.hpp"

#include "machine/instruction_levels.hpp"
#include "surfaces/placed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

namespace {

// Looks at the triangles near a body.
std::size_t spots_of_mesh(const TriangleMesh& mesh, const SpotRule& rule, const Vec3& here, double radius,
                          double skin, NearWalls::Clearance& known, std::vector<NearTriangle>& near) {
  // Beyond some skins a bound will do: from the axis of a drum all triangles are equally near.
  constexpr double skins = 30;
  // In skins, further than the skin: the more, the more triangles, but the less often.
  constexpr double margin = 3;
  const double reach = radius + skin;
  known.smooth_skin = (1 + margin) * skin;
  mesh.triangles().find_near(here, radius + known.smooth_skin, near);
  known.smooth_travel = smooth_travel(mesh, rule, here, near);
  if (near.empty())
    known.distance = mesh.triangles().nearest(here, radius + skins * skin).distance - radius;
  else
    known.distance = near[0].distance - radius;
  const auto beyond =
      std::find_if(near.begin(), near.end(), [&](const NearTriangle& n) { return !(n.distance <= reach); });
  return spots_possible(mesh, rule, here, std::span(near.begin(), beyond));
}

// Most spots in which a body may touch a surface before the next search. known: from an earlier call.
std::size_t spots_near(const PlacedSurface& surface, const Sphere& body, double skin, double approached,
                       NearWalls::Clearance& known, std::vector<NearTriangle>& near) {
  const bool jumps = surface.distance_jumps();
  if (!jumps && known.distance - (approached - known.approached) >= skin) return 0;
  const Vec3 here = surface.in_frame(body.position);
  const double moved = norm(here - known.centre);
  if (!jumps && known.distance - moved >= skin) return 0;
  if (moved < known.smooth_travel && skin + moved < known.smooth_skin &&
      known.distance + moved < skin / distance_slack)
    return 1;
  known.centre = here, known.approached = approached;
  if (!surface.mesh()) {
    known.distance = surface.nearest(body.position).distance - body.radius;
    return known.distance < skin;
  }
  return spots_of_mesh(*surface.mesh(), surface.rule(), here, body.radius, skin, known, near);
}

// Walls near the bodies of a range, of each body in the order of their numbers.
SCREE_EVERY_LEVEL_INLINED void add_near_walls(std::span<const Sphere> bodies, BodyRange range,
                                              const Boundaries& boundaries,
                                              const std::vector<PlacedSurface>& surfaces, int dimension,
                                              double skin, double approached, NearWalls::Clearance* known,
                                              std::vector<PlanePair>& pairs) {
  const std::vector<scree_plane>& planes = boundaries.planes();
  std::vector<NearTriangle> near;
  for (std::uint32_t i = std::uint32_t(range.begin); i < range.end; ++i) {
    for (std::uint32_t w = 0; w < planes.size(); ++w) {
      if (boundaries.absent()[w]) continue;
      double height = 0;
      for (int k = 0; k < dimension; ++k)
        height += (bodies[i].position[k] - planes[w].point[k]) * planes[w].normal[k];
      if (height < bodies[i].radius + skin) pairs.push_back({i, w});
    }
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
      if (boundaries.absent()[planes.size() + s]) continue;
      const std::size_t spots =
          spots_near(surfaces[s], bodies[i], skin, approached, known[i * surfaces.size() + s], near);
      for (std::uint32_t spot = 0; spot < spots; ++spot)
        pairs.push_back({i, std::uint32_t(planes.size()) + s, spot});
    }
  }
}

}  // namespace

std::vector<PlanePair> NearWalls::find(std::span<const Sphere> bodies,
                                       const std::vector<std::uint32_t>& tiles, const Boundaries& boundaries,
                                       double skin, double approach, ThreadPool& threads) {
  const std::vector<PlacedSurface> surfaces = placed_surfaces(boundaries.surfaces(), boundaries.dimension());
  if (std::isfinite(approach))
    approached_ += approach;
  else
    forget();
  constexpr double unknown = -std::numeric_limits<double>::infinity();
  if (clearances_.size() != bodies.size() * surfaces.size())
    clearances_.assign(bodies.size() * surfaces.size(), {{}, unknown, 0, 0, 0});
  // Bodies that are folded into a period come to other places of surfaces.
  const double approached = boundaries.domain().any_periodic() ? -unknown : approached_;
  std::vector<std::vector<PlanePair>> near(tiles.size());
  threads.each(tiles.size(), [&](std::size_t k, unsigned) {
    add_near_walls(bodies, BodyTiles(bodies.size())[tiles[k]], boundaries, surfaces, boundaries.dimension(),
                   skin, approached, clearances_.data(), near[k]);
  });
  std::vector<PlanePair> all;
  for (const std::vector<PlanePair>& of_tile : near) all.insert(all.end(), of_tile.begin(), of_tile.end());
  return all;
}

}  // namespace scree
