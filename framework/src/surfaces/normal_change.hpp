#pragma once

#include "surfaces/nearest_point.hpp"
#include "surfaces/placed_surface.hpp"
#include "surfaces/triangle_mesh.hpp"

#include <scree/pair_variation.hpp>

namespace scree {

// Derivative (1/m) of the normal of a nearest point with the place x of the body (m), both in the frame of
// the surface: κ/(1 + κ d) across a direction in which the surface has the curvature κ, 1/d across an edge.
// Where two parts of a surface meet, of one of them; 0 where a body is equally near to a whole circle.
Matrix3 normal_change(const scree_surface& surface, int dimension, const Vec3& x,
                      const NearestPoint& nearest);
// Of a spot of a mesh.
Matrix3 normal_change(const TriangleMesh& mesh, const Vec3& x, const NearestPoint& spot);

// Of any surface in the axes of the scene, from x and the nearest point in the frame of the surface.
Matrix3 normal_change_in_scene(const PlacedSurface& placed, int dimension, const Vec3& x,
                               const NearestPoint& nearest);

// Derivative (1/m²) of the first curvature of the nearest point with the place of the body: 0 but on cones.
Vec3 curvature_change(const scree_surface& surface, const Vec3& x, const NearestPoint& nearest);

}  // namespace scree
