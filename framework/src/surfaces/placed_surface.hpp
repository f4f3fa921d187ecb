#pragma once

#include "surfaces/contact_spots.hpp"
#include "surfaces/nearest_point.hpp"

#include <vector>

#include <scree/plugin/rotation.hpp>
#include <scree/wall_surfaces.hpp>

namespace scree {

// A surface where it is at the end of a step, with its motion in the step.
class PlacedSurface {
 public:
  // step: (s) 0: mid_velocity and mid_spin of the frame are velocities at one time.
  PlacedSurface(const WallSurfaces& all, std::size_t surface, int dimension, double step);

  // The nearest point to x (m), in the scene.
  NearestPoint nearest(const Vec3& x) const;
  const scree_surface& surface() const { return surface_; }
  // Null if it is no mesh.
  const TriangleMesh* mesh() const { return mesh_; }
  // Whether the distance of a body may jump while it moves: from the edge of one side to its back.
  bool distance_jumps() const {
    return !mesh_ && surface_.side != SCREE_BOTH_SIDES && has_edges(surface_, dimension_);
  }
  // How a body touches the mesh.
  SpotRule rule() const { return {surface_.side, cosine_smooth_}; }
  // From the scene to the frame of the surface, and back.
  Vec3 in_frame(const Vec3& x) const { return to_scene_.back()(x - origin_); }
  Vec3 point_in_scene(const Vec3& point) const { return origin_ + to_scene_(point); }
  NearestPoint in_scene(NearestPoint found) const {
    found.point = point_in_scene(found.point);
    found.normal = to_scene_(found.normal);
    return found;
  }
  const Rotation& to_scene() const { return to_scene_; }
  const Rotation& mid_to_scene() const { return mid_to_scene_; }
  // Velocity (m/s) of the material that is at a point (m) of the scene at the end of the step; and of that
  // which is there in its middle, its displacement in the step / step.
  Vec3 velocity_at(const Vec3& point) const { return velocity_ + cross(spin_, point - origin_); }
  Vec3 mid_velocity_at(const Vec3& point) const { return mid_velocity_ + cross(chord_, point - mid_origin_); }
  // The same in the middle of the step.
  Vec3 mid_in_frame(const Vec3& x) const { return mid_to_scene_.back()(x - mid_origin_); }
  Vec3 mid_point_in_scene(const Vec3& point) const { return mid_origin_ + mid_to_scene_(point); }
  NearestPoint mid_in_scene(NearestPoint found) const {
    found.point = mid_point_in_scene(found.point);
    found.normal = mid_to_scene_(found.normal);
    return found;
  }
  const Vec3& origin() const { return origin_; }
  const Vec3& spin() const { return spin_; }
  const Vec3& mid_spin() const { return mid_spin_; }

 private:
  PlacedSurface(const scree_surface& surface, const TriangleMesh* mesh, const scree_frame& frame,
                int dimension, double step);

  const scree_surface& surface_;
  const TriangleMesh* mesh_;
  int dimension_;
  Vec3 origin_, velocity_, spin_, mid_velocity_, mid_spin_, mid_origin_;
  Rotation to_scene_, mid_to_scene_;
  double cosine_smooth_;
  Vec3 chord_;  // (rad/s) times a place in the middle of a turn: its displacement / step
};

// All surfaces. step: (s) see PlacedSurface.
std::vector<PlacedSurface> placed_surfaces(const WallSurfaces& all, int dimension, double step = 0);

}  // namespace scree
