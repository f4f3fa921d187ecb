#pragma once

#include <scree/contact_columns.hpp>
#include <scree/plugin_checks/law_checks.hpp>

namespace scree::plugin_checks {

// A change of the frame of reference, under which the outputs of a law must change likewise.
struct Frame {
  bool exchanged = false;  // a and b change their names
  double angle = 0;        // (rad) by which everything is rotated about `axis`
  Vec3 axis = {{0, 0, 1}};

  Vec3 operator()(const Vec3& v) const;  // rotates a vector, without exchange
};

// A prescribed sequence of contact inputs: two bodies touch, press, slide and turn against each other, and
// part. Its variants differ in speed and direction.
class Passage {
 public:
  // contact_time (s): sets the largest overlap, speed × contact_time/π.
  Passage(int dimension, const CheckedPair& pair, double contact_time);

  static constexpr int steps_touching = 40;
  static constexpr int steps = steps_touching + 3;  // the last ones apart

  double step() const { return contact_time_ / steps_touching; }  // (s)
  double overlap() const { return overlap_; }                     // (m) largest
  double distance() const { return 2.5 * pair_.radius; }          // (m) of the centres
  double speed() const { return pair_.speed; }                    // (m/s)
  double spin() const { return pair_.speed / pair_.radius; }      // (rad/s)
  // Sets the inputs of contact i at a step, 0 … steps − 1.
  void set(ContactColumns& contacts, std::size_t i, int variant, int step, const Frame& frame = {}) const;

 private:
  int dimension_;
  CheckedPair pair_;
  double contact_time_, overlap_;
};

}  // namespace scree::plugin_checks
