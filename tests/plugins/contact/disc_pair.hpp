#pragma once

#include "touching_pair.hpp"

namespace scree::test {

struct DiscPose {
  Vec2 a = {}, b = {};              // centres (m); of a wall its point
  double angle_a = 0, angle_b = 0;  // (rad)

  Vec<1> orientation_a() const { return {{angle_a}}; }
  Vec<1> orientation_b() const { return {{angle_b}}; }
};

// A pair of discs, or a disc and a wall.
class DiscPair : public TouchingPair<2, DiscPose> {
 public:
  using TouchingPair::TouchingPair;

  double spring() const { return law().history("spring"); }
  double rolling() const { return law().history("rolling"); }
  double torque_a() const { return torque_on_a()[0]; }
  double torque_b() const { return torque_on_b()[0]; }
};

}  // namespace scree::test
