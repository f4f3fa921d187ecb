#pragma once

#include <cmath>

#include <scree/plugin/abi.h>
#include <scree/plugin/vec.hpp>

namespace scree {

// Where a surface is nearest to the centre of a body, in the frame of the surface.
struct NearestPoint {
  Vec3 point;       // (m)
  Vec3 normal;      // unit, from the surface to the side on which the body is
  double distance;  // (m) of the centre along the normal; below 0 behind a surface with one side
  Vec2 curvature;   // (1/m) principal ones of the surface, above 0 where it bulges towards the body; in 2D
                    // twice the same; 0 on edges
};

// A body that is larger than the hollow in which it lies would have an effective radius below 0: it has at
// most this many times its own.
constexpr double largest_effective_radius = 1e3;

// R* (m) of a Hertz contact of a body with the curvature 1/R (1/m) on a surface with these principal ones:
//   1/R*² = (1/R + κ₁) (1/R + κ₂)
// exact for spheres; for cylinders and cones, whose contacts are elliptic, the force has an error of
// 0.02 (R κ)² (Johnson 1985, eq. 4.26, without F₂).
inline double effective_radius_at(const Vec2& surface, double of_body) {
  const double least = of_body / largest_effective_radius;
  const double first = of_body + surface[0], second = of_body + surface[1];
  return 1 / std::sqrt((first < least ? least : first) * (second < least ? least : second));
}

// The nearest point to x (m) of a surface that is no mesh; of several that are equally near, one. x: in the
// frame of the surface.
NearestPoint nearest_point(const scree_surface& surface, int dimension, const Vec3& x);

// Why a surface is none, or "".
const char* problem_of(const scree_surface& surface, int dimension);

// Largest distance (m) of a point of the surface, which is no mesh, from the origin of its frame; may be
// infinite.
double reach_of(const scree_surface& surface, int dimension);

// Whether a surface that is no mesh ends somewhere.
bool has_edges(const scree_surface& surface, int dimension);

// Whether a spin about the axis z of its frame, in 2D about the origin, leaves a surface as it is.
bool turns_into_itself(const scree_surface& surface, int dimension);

}  // namespace scree
