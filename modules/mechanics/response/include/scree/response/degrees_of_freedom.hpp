#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace scree::response {

// Numbers the degrees of freedom of a linear system: for each body its translations (m), then its rotations
// (rad); after the bodies the displacements of walls that forces move (m). Motions that a body or wall does not have are
// left out.
class DegreesOfFreedom {
 public:
  static constexpr Eigen::Index none = -1;

  // spins: 0, 1 or 3. translates, rotates: for each body; a body without translations has no rotations. free_walls:
  // whether forces move the wall.
  DegreesOfFreedom(int dimension, int spins, const std::vector<bool>& translates,
                   const std::vector<bool>& rotates, const std::vector<bool>& free_walls = {});

  int dimension() const { return dimension_; }
  int spins() const { return spins_; }
  Eigen::Index size() const { return size_; }
  std::size_t bodies() const { return translation_.size(); }
  std::size_t walls() const { return wall_.size(); }
  // Whether a body has translations; a body that is left out or fixed has none.
  bool moves(std::size_t body) const { return translation_[body] != none; }
  // Number of the component k of the displacement of a body, 0 <= k < dimension; `none` if it is left out.
  Eigen::Index translation(std::size_t body, int k) const { return offset(translation_[body], k); }
  // Number of its rotation about axis k, 0 <= k < spins; in 2D the only axis is z.
  Eigen::Index rotation(std::size_t body, int k) const { return offset(rotation_[body], k); }
  // Number of the displacement of a wall along its direction; `none` if it is left out.
  Eigen::Index wall(std::size_t wall) const { return wall_[wall]; }

 private:
  static Eigen::Index offset(Eigen::Index first, int k) { return first == none ? none : first + k; }

  int dimension_, spins_;
  Eigen::Index size_ = 0;
  std::vector<Eigen::Index> translation_, rotation_, wall_;
};

}  // namespace scree::response
