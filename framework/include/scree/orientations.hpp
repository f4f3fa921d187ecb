#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <scree/body_column.hpp>
#include <scree/strided.hpp>

namespace scree {

struct BodyRange;

// Rotation of each body since the start of a run: in 2D an angle (rad), not reduced to one turn; in 3D a unit
// quaternion (w, x, y, z). Carried only by scenes with a law or probe that reads it.
class Orientations {
 public:
  // Carries nothing.
  Orientations() = default;
  // No body has turned yet.
  Orientations(int dimension, std::size_t bodies);
  // Room for bodies, which takes up no memory before it is written.
  static Orientations room_for(int dimension, std::size_t bodies);

  explicit operator bool() const { return components_ > 0; }
  int components() const { return components_; }  // 1 or 4; 0 if not carried
  // One component of all bodies.
  Strided<const double> operator[](int k) const { return {values_.data() + k, stride(), size_}; }
  const double* data() const { return values_.data(); }
  double* data() { return values_.data(); }
  // Doubles per body: the components, and for each the part that rounding took from it.
  std::size_t stride() const { return 2 * std::size_t(components_); }

  // Rotates the bodies [begin, end) about their spins (rad/s) for a time (s), exactly for constant spins.
  // Round-off does not accumulate: sums are compensated, and quaternions keep their norm.
  void rotate(const Vectors<const double>& spin, double time, std::size_t begin, std::size_t end);

  // Moves the bodies in memory, see Particles::rearrange.
  void rearrange(const std::vector<std::uint32_t>& from, std::span<const BodyRange> kept);
  // See Particles::copy_in_scene_order.
  void copy_in_scene_order(const class BodyOrder& order, Orientations& copy) const;
  void copy_in_scene_order(const class BodyOrder& order, Orientations& copy,
                           const std::vector<std::uint32_t>& numbers) const;

  // Saves or restores the orientations of the first bodies.
  void transfer(const class StateTransfer& state, std::size_t bodies);

  // Whether a state has orientations of bodies.
  static bool are_in(const class StateTransfer& state);

 private:
  int components_ = 0;
  std::size_t size_ = 0;
  BodyColumn<double> values_;  // (bodies, stride)
};

}  // namespace scree
