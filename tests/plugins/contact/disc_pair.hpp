#pragma once

#include "law_batch.hpp"

#include <cmath>

// A pair of discs, or a disc and a wall, that a test moves along a path: the inputs of the law follow from the
// positions and angles before and after each step, as in the kernel but written separately.

namespace scree::test {

struct DiscPose {
  Vec2 a = {}, b = {};              // centres (m); of a wall its point
  double angle_a = 0, angle_b = 0;  // (rad)
};

class DiscPair {
 public:
  // radius_b = 0: b is a wall with the normal (0, 1).
  DiscPair(const std::string& plugin, const Values& values, double radius_a, double radius_b,
           const DiscPose& start)
      : law_(plugin, values, 2), radius_a_(radius_a), radius_b_(radius_b), pose_(start) {
    law_.input(SCREE_EFFECTIVE_RADIUS) = wall() ? radius_a : radius_a * radius_b / (radius_a + radius_b);
    law_.input(SCREE_RADII, 0) = radius_a;
    law_.input(SCREE_RADII, 1) = radius_b;
    evaluate(start, start);
  }

  // Moves the pair along pose(s), 0 < s <= 1, in `steps` steps.
  template <class Pose>
  void follow(const Pose& pose, int steps) {
    for (int k = 1; k <= steps; ++k) {
      const DiscPose next = pose(double(k) / steps);
      evaluate(pose_, next);
      pose_ = next;
    }
  }

  LawBatch& law() { return law_; }
  const DiscPose& pose() const { return pose_; }
  double spring() const { return law_.history("spring"); }
  double rolling() const { return law_.history("rolling"); }
  double energy() const { return law_.output(SCREE_ELASTIC_NORMAL) + law_.output(SCREE_ELASTIC_TANGENTIAL); }
  Vec2 force() const { return {{law_.output(SCREE_FORCE, 0), law_.output(SCREE_FORCE, 1)}}; }
  // Torques on a and b, with the law's arms.
  double torque_a() const { return -arm(radius_a_) * lever() + couple(); }
  double torque_b() const { return wall() ? 0 : -arm(radius_b_) * lever() - couple(); }

 private:
  bool wall() const { return radius_b_ == 0; }
  Vec2 normal(const DiscPose& p) const {
    if (wall()) return {{0, 1}};
    const Vec2 apart = p.a - p.b;
    return (1 / norm(apart)) * apart;
  }
  double distance(const DiscPose& p) const { return wall() ? p.a[1] - p.b[1] : norm(p.a - p.b); }
  double couple() const { return law_.instance().writes_couple ? law_.output(SCREE_COUPLE) : 0; }
  double lever() const {
    const Vec2 n = normal(pose_);
    return n[0] * force()[1] - n[1] * force()[0];
  }
  double arm(double radius, double overlap) const {
    return law_.instance().arms == SCREE_ARM_RADIUS ? radius : radius - 0.5 * overlap;
  }
  double arm(double radius) const { return arm(radius, radius_a_ + radius_b_ - distance(pose_)); }

  void evaluate(const DiscPose& from, const DiscPose& to) {
    const DiscPose middle = {.a = 0.5 * (from.a + to.a), .b = 0.5 * (from.b + to.b)};
    const Vec2 n = normal(to), mid_normal = normal(middle);
    const double overlap = radius_a_ + radius_b_ - distance(to);
    const double mid_overlap = radius_a_ + radius_b_ - distance(middle);
    const double turn_a = to.angle_a - from.angle_a, turn_b = to.angle_b - from.angle_b;
    const Vec2 t = {{-mid_normal[1], mid_normal[0]}}, moved = (to.a - from.a) - (to.b - from.b);
    const double along = dot(moved, t) - arm(radius_a_, mid_overlap) * turn_a -
                         (wall() ? 0 : arm(radius_b_, mid_overlap) * turn_b);
    law_.set(SCREE_NORMAL, {{n[0], n[1], 0}});
    law_.set(SCREE_TANGENTIAL_INCREMENT, {{along * t[0], along * t[1], 0}});
    law_.set(SCREE_SEPARATION, {{to.a[0] - to.b[0], to.a[1] - to.b[1], 0}});
    law_.input(SCREE_OVERLAP) = overlap;
    law_.input(SCREE_RELATIVE_SPIN) = turn_a - turn_b;  // with steps of 1 s
    law_.input(SCREE_ORIENTATION_A) = to.angle_a;
    law_.input(SCREE_ORIENTATION_B) = to.angle_b;
    law_.evaluate(1);
  }

  LawBatch law_;
  double radius_a_, radius_b_;
  DiscPose pose_;
};

}  // namespace scree::test
