#include "surfaces/placed_surface.hpp"

namespace scree {

namespace {

Vec3 vector(const double (&v)[3]) { return {{v[0], v[1], v[2]}}; }

}  // namespace

// A turn by θ about an axis moves what is at r in its middle by 2 sin(θ/2) axis × r.
PlacedSurface::PlacedSurface(const scree_surface& surface, const scree_frame& frame, int dimension,
                             double step)
    : surface_(surface),
      dimension_(dimension),
      origin_(vector(frame.position)),
      velocity_(vector(frame.velocity)),
      spin_(vector(frame.spin)),
      mid_velocity_(vector(frame.mid_velocity)),
      mid_spin_(vector(frame.mid_spin)),
      to_scene_{frame.orientation[0], {{frame.orientation[1], frame.orientation[2], frame.orientation[3]}}},
      half_back_(Rotation::by(-0.5 * step * mid_spin_)),
      chord_(step != 0 ? 2 / step * half_angle_of(step * mid_spin_).sine : mid_spin_) {}

NearestPoint PlacedSurface::nearest(const Vec3& x) const {
  NearestPoint found = nearest_point(surface_, dimension_, to_scene_.back()(x - origin_));
  found.point = origin_ + to_scene_(found.point);
  found.normal = to_scene_(found.normal);
  return found;
}

}  // namespace scree
