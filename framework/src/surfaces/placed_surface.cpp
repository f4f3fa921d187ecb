#include "surfaces/placed_surface.hpp"

namespace scree {

namespace {

// The same on all machines, unlike the library's cosine.
double cosine_of(double angle) {
  const double half = 1 + half_angle_of({{angle, 0, 0}}).cosine_minus_one;
  return 2 * half * half - 1;
}

}  // namespace

// A turn by θ about an axis moves what is at r in its middle by 2 sin(θ/2) axis × r.
PlacedSurface::PlacedSurface(const WallSurfaces& all, std::size_t surface, int dimension, double step)
    : PlacedSurface(all.shapes[surface], all.meshes[surface].get(), all.frames[surface], dimension, step) {}

PlacedSurface::PlacedSurface(const scree_surface& surface, const TriangleMesh* mesh, const scree_frame& frame,
                             int dimension, double step)
    : surface_(surface),
      mesh_(mesh),
      dimension_(dimension),
      origin_(vector_of(frame.position)),
      velocity_(vector_of(frame.velocity)),
      spin_(vector_of(frame.spin)),
      mid_velocity_(vector_of(frame.mid_velocity)),
      mid_spin_(vector_of(frame.mid_spin)),
      mid_origin_(origin_ - 0.5 * step * mid_velocity_),
      to_scene_(rotation_of(frame)),
      mid_to_scene_(Rotation::by(-0.5 * step * mid_spin_) * to_scene_),
      cosine_smooth_(mesh ? cosine_of(surface.size[1]) : 1),
      chord_(step != 0 ? 2 / step * half_angle_of(step * mid_spin_).sine : mid_spin_) {}

NearestPoint PlacedSurface::nearest(const Vec3& x) const {
  const Vec3 here = in_frame(x);
  return in_scene(mesh_ ? nearest_spot(*mesh_, rule(), here) : nearest_point(surface_, dimension_, here));
}

std::vector<PlacedSurface> placed_surfaces(const WallSurfaces& all, int dimension, double step) {
  std::vector<PlacedSurface> placed;
  for (std::size_t s = 0; s < all.size(); ++s) placed.emplace_back(all, s, dimension, step);
  return placed;
}

}  // namespace scree
