#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <scree/body_group.hpp>

namespace scree::response {

// Numbers the degrees of freedom of a linear system: for each body its translations (m), then its rotations
// (rad); after the bodies the displacements of walls that forces move (m), then the angles of walls that
// torques turn (rad). Motions that a body or wall does not have are left out.
class DegreesOfFreedom {
 public:
  static constexpr Eigen::Index none = -1;

  // Consecutive numbers.
  struct Numbers {
    Eigen::Index first = none, count = 0;
  };

  // spins: 0, 1 or 3. translates, rotates: for each body; a body without translations has no rotations.
  // free_walls: whether forces move the wall. held: components that bodies do not have; empty: none.
  // turning_walls: whether torques turn the wall; empty: none.
  DegreesOfFreedom(int dimension, int spins, const std::vector<bool>& translates,
                   const std::vector<bool>& rotates, const std::vector<bool>& free_walls = {},
                   std::vector<freedom::Mask> held = {}, const std::vector<bool>& turning_walls = {});

  int dimension() const { return dimension_; }
  int spins() const { return spins_; }
  Eigen::Index size() const { return size_; }
  std::size_t bodies() const { return translation_.size(); }
  std::size_t walls() const { return wall_.size(); }
  // Whether a body has any; a body that is left out or fixed has none.
  bool moves(std::size_t body) const { return translation_[body] != none || rotation_[body] != none; }
  // Number of the component k of the displacement of a body, 0 <= k < dimension; `none` if it is left out or
  // held.
  Eigen::Index translation(std::size_t body, int k) const { return number(translation_[body], body, 0, k); }
  // Number of its rotation about axis k, 0 <= k < spins; in 2D the only axis is z.
  Eigen::Index rotation(std::size_t body, int k) const {
    return number(rotation_[body], body, first_rotation(), k);
  }
  Numbers translations(std::size_t body) const {
    return {translation_[body], translation_[body] == none ? 0 : count(body, 0, dimension_)};
  }
  Numbers rotations(std::size_t body) const {
    return {rotation_[body], rotation_[body] == none ? 0 : count(body, first_rotation(), spins_)};
  }
  // Number of the displacement of a wall along its direction; `none` if it is left out.
  Eigen::Index wall(std::size_t wall) const { return wall_[wall]; }
  // Number of its angle; `none` if it is left out.
  Eigen::Index turn(std::size_t wall) const { return turn_[wall]; }

 private:
  int first_rotation() const { return dimension_ == 2 ? freedom::count - 1 : freedom::first_rotation; }
  bool is_held(std::size_t body, int component) const {
    return !held_.empty() && freedom::is_in(held_[body], component);
  }
  // Components of a body from `first` on, of k, that are not held.
  Eigen::Index count(std::size_t body, int first, int k) const {
    Eigen::Index sum = 0;
    for (int c = first; c < first + k; ++c) sum += !is_held(body, c);
    return sum;
  }
  Eigen::Index number(Eigen::Index start, std::size_t body, int first, int k) const {
    return start == none || is_held(body, first + k) ? none : start + count(body, first, k);
  }

  int dimension_, spins_;
  Eigen::Index size_ = 0;
  std::vector<Eigen::Index> translation_, rotation_, wall_, turn_;
  std::vector<freedom::Mask> held_;
};

}  // namespace scree::response
