#pragma once

#include "law_batch.hpp"

#include <cmath>

// Two touching bodies, or a body and a wall, that a test moves along a path: the inputs of the law follow
// from the positions and orientations before and after each step, as in the kernel but written separately.

namespace scree::test {

inline constexpr double infinite_friction = 1e9;

// Rotation (rad) from one orientation to another: of angles, and of unit quaternions (w, x, y, z) the
// rotation vector.
inline Vec<1> turn_between(const Vec<1>& from, const Vec<1>& to) { return to - from; }
inline Vec3 turn_between(const Vec<4>& from, const Vec<4>& to) {
  const Vec3 u = {{from[1], from[2], from[3]}}, v = {{to[1], to[2], to[3]}};
  const double w = to[0] * from[0] + dot(u, v);
  const Vec3 axis = from[0] * v - to[0] * u - cross(v, u);
  const double sine = norm(axis);
  return sine > 0 ? (2 * std::atan2(sine, w) / sine) * axis : Vec3{};
}

// Pose: positions a and b (m; b of a wall is its point), and orientation_a(), orientation_b() as the law
// reads them.
template <int D, class Pose>
class TouchingPair {
 public:
  using Spin = Vec<spin_components<D>>;

  // radius_b = 0: b is a wall whose normal is the last axis.
  TouchingPair(const std::string& plugin, const Values& values, double radius_a, double radius_b,
               const Pose& start)
      : law_(plugin, values, D), radius_a_(radius_a), radius_b_(radius_b), pose_(start) {
    law_.input(SCREE_EFFECTIVE_RADIUS) = wall() ? radius_a : radius_a * radius_b / (radius_a + radius_b);
    law_.input(SCREE_RADII, 0) = radius_a;
    law_.input(SCREE_RADII, 1) = radius_b;
    evaluate(start, start);
  }

  // Moves the pair along pose(s), 0 < s <= 1, in `steps` steps of 1 s.
  template <class Path>
  void follow(const Path& pose, int steps) {
    for (int k = 1; k <= steps; ++k) {
      const Pose next = pose(double(k) / steps);
      evaluate(pose_, next);
      pose_ = next;
    }
  }

  LawBatch& law() { return law_; }
  const LawBatch& law() const { return law_; }
  const Pose& pose() const { return pose_; }
  double energy() const { return law_.output(SCREE_ELASTIC_NORMAL) + law_.output(SCREE_ELASTIC_TANGENTIAL); }
  Vec<D> force() const {
    Vec<D> force;
    for (int k = 0; k < D; ++k) force[k] = law_.output(SCREE_FORCE, k);
    return force;
  }
  // Torques on a and b, with the law's arms.
  Spin torque_on_a() const { return -arm(radius_a_) * lever() + couple(); }
  Spin torque_on_b() const { return wall() ? Spin{} : -arm(radius_b_) * lever() - couple(); }

 private:
  bool wall() const { return radius_b_ == 0; }
  Vec<D> normal(const Pose& p) const {
    Vec<D> up = {};
    up[D - 1] = 1;
    const Vec<D> apart = p.a - p.b;
    return wall() ? up : (1 / norm(apart)) * apart;
  }
  double distance(const Pose& p) const { return wall() ? p.a[D - 1] - p.b[D - 1] : norm(p.a - p.b); }
  Spin couple() const {
    Spin couple = {};
    for (int k = 0; law_.instance().writes_couple && k < spin_components<D>; ++k)
      couple[k] = law_.output(SCREE_COUPLE, k);
    return couple;
  }
  Spin lever() const { return cross(normal(pose_), force()); }
  double arm(double radius, double overlap) const {
    return law_.instance().arms == SCREE_ARM_RADIUS ? radius : radius - 0.5 * overlap;
  }
  double arm(double radius) const { return arm(radius, radius_a_ + radius_b_ - distance(pose_)); }

  template <int N>
  void set(scree_contact_input column, const Vec<N>& v) {
    for (int k = 0; k < N; ++k) law_.input(column, k) = v[k];
  }

  void evaluate(const Pose& from, const Pose& to) {
    Pose middle = from;
    middle.a = 0.5 * (from.a + to.a), middle.b = 0.5 * (from.b + to.b);
    const Vec<D> mid_normal = normal(middle);
    const double mid_overlap = radius_a_ + radius_b_ - distance(middle);
    const Spin turn_a = turn_between(from.orientation_a(), to.orientation_a()),
               turn_b = turn_between(from.orientation_b(), to.orientation_b());
    const double arm_b = wall() ? 0 : arm(radius_b_, mid_overlap);
    const Vec<D> moved = (to.a - from.a) - (to.b - from.b) -
                         cross(arm(radius_a_, mid_overlap) * turn_a + arm_b * turn_b, mid_normal);
    set(SCREE_NORMAL, normal(to));
    set(SCREE_RELATIVE_VELOCITY, moved);
    set(SCREE_TANGENTIAL_INCREMENT, tangential_part(moved, mid_normal));
    set(SCREE_SEPARATION, to.a - to.b);
    set(SCREE_RELATIVE_SPIN, turn_a - turn_b);
    set(SCREE_ORIENTATION_A, to.orientation_a());
    set(SCREE_ORIENTATION_B, to.orientation_b());
    law_.input(SCREE_OVERLAP) = radius_a_ + radius_b_ - distance(to);
    law_.evaluate(1);
  }

  LawBatch law_;
  double radius_a_, radius_b_;
  Pose pose_;
};

}  // namespace scree::test
