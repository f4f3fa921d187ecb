#pragma once

#include "surfaces/placed_surface.hpp"

#include <cmath>
#include <cstddef>

#include <scree/plugin/vec.hpp>

namespace scree {

// What a body meets at a surface: the nearest point, and the motion of the wall there.
struct SurfacePoint {
  Vec3 point, normal, mid_normal;  // the normal also in the middle of the step
  Vec3 velocity, mid_velocity;     // (m/s) the latter where the nearest point is in the middle of the step
};

// nearest, middle: in the scene, at the end of the step and in its middle.
inline SurfacePoint surface_point(const PlacedSurface& surface, const NearestPoint& nearest,
                                  const NearestPoint& middle) {
  return {nearest.point, nearest.normal, middle.normal, surface.velocity_at(nearest.point),
          surface.mid_velocity_at(middle.point)};
}

// Bodies near one surface that is no mesh, in columns.
class ShapeContacts {
 public:
  static constexpr std::size_t most = 16;  // bodies

  bool full() const { return count_ == most; }
  std::size_t count() const { return count_; }
  void clear() { count_ = 0; }
  // A body at the end and in the middle of the step, each in the periodic domain (m). beyond: periods by
  // which it lies beyond it at the end (m).
  struct Body {
    Vec3 x, middle, beyond;
    double radius;
  };
  void add(std::size_t pair, const Body& body);
  // Finds the points that all of them meet.
  void find(const PlacedSurface& surface, int dimension);
  std::size_t pair(std::size_t k) const { return pair_[k]; }
  const Vec3& beyond(std::size_t k) const { return beyond_[k]; }
  Vec3 centre(std::size_t k) const { return {{x_[0][k], x_[1][k], x_[2][k]}}; }
  double radius(std::size_t k) const { return radius_[k]; }
  SurfacePoint point(std::size_t k) const;
  double effective_radius(std::size_t k) const { return effective_radius_[k]; }

 private:
  struct Loops;
  using Columns = double[3][most];

  std::size_t count_ = 0;
  std::size_t pair_[most];
  Vec3 beyond_[most];
  alignas(64) Columns x_, middle_, point_, normal_, mid_normal_, velocity_, mid_velocity_;
  alignas(64) double radius_[most], effective_radius_[most];
};

}  // namespace scree
