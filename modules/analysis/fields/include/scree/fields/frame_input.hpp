#pragma once

#include <unordered_map>

#include <scree/fields/field_input.hpp>
#include <scree/pictures/frame.hpp>
#include <scree/state.hpp>

namespace scree::fields {

// What frames of a run do not have, the same in all of them.
class FrameFacts {
 public:
  // From a state of the run: masses, held components, periods. Throws Error if it is not a state.
  explicit FrameFacts(const State& state);
  // Of bodies of one density (kg/m³), all free, in a scene without periodic faces.
  explicit FrameFacts(double density) : density_(density) {}

  const Domain& domain() const { return domain_; }
  // Sets mass and held components of a body that has its id and radius. Throws Error if the state has no such
  // body.
  void complete(FieldBody& body, int dimension) const;

 private:
  struct Facts {
    double mass;
    freedom::Mask held;
  };
  double density_ = 0;
  Domain domain_ = {};
  std::unordered_map<std::int64_t, Facts> bodies_;
};

// Bodies and contacts of a frame that a run wrote. Its frames have the force on each body but not its parts:
// the body force is all that no contact exerts, loads of groups included. Throws Error if velocities, forces
// or contacts are missing.
FieldInput input_of_frame(const pictures::Frame& frame, const FrameFacts& facts);

}  // namespace scree::fields
