#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <scree/contact_kinematics.hpp>
#include <scree/pair_variation.hpp>
#include <scree/wall_surfaces.hpp>

namespace scree {

// Where a body touches a surface, in the frame of the surface.
struct SurfaceSpot {
  Vec3 point = {}, normal = {};  // (m), unit
};

// A body at a surface.
struct SurfacePlace {
  PairDirection<3> direction;  // unit normal from the surface to the body, distance of its centre (m)
  double effective_radius;     // R* (m) of a Hertz contact
  PairVariation change;        // while the body moves
  Vec<4> orientation;          // quaternion (w, x, y, z) of the frame of the surface
  SurfaceSpot spot;
};

// A body and one surface of all.
struct BodyAtSurface {
  std::size_t surface;
  int dimension;
  Vec3 from_origin;     // (m) its centre from the origin of the frame of the surface
  double radius;        // (m)
  bool follows = true;  // whether its law follows surfaces, and needs how the change of the normal changes
};
// Where the surface, which is no mesh, is nearest to the body.
SurfacePlace nearest_place(const WallSurfaces& all, const BodyAtSurface& body);
// In a direction in which the body touches the surface, one of several on a mesh.
SurfacePlace place_towards(const WallSurfaces& all, const BodyAtSurface& body,
                           const PairDirection<3>& direction);

// Spots of a mesh within a distance (m) of the centre, the nearest first.
std::vector<SurfaceSpot> spots_within(const WallSurfaces& all, const BodyAtSurface& body, double reach);
// Where the body is at each of some former spots, if one goes on from it.
std::vector<std::optional<SurfacePlace>> places_after(const WallSurfaces& all, const BodyAtSurface& body,
                                                      double reach, std::span<const SurfaceSpot> former);

}  // namespace scree
