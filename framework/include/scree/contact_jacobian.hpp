#pragma once

#include <vector>

#include <scree/plugin_host.hpp>

namespace scree {

// Exact Jacobians of a contact law: the change of force and couple of touching pairs with the motion of a
// relative to b during the step, on the branch (sticking, sliding, ...) on which the law is, with the history
// before the step. Linear response and stiffness matrices are assembled from them.
//
// Rows: force on a (N), D of them, then couple (N m), S. Columns, 2 (D + S):
//   displacement (m)       of a's contact point relative to b's; changes the overlap by −n·u and the
//                          tangential increment by u − n (n·u), and turns the normal
//   rotation (rad)         of a relative to b, which is held, while the contact points keep their positions;
//                          changes the orientation of a
//   velocity (m/s)         of a's contact point relative to b's
//   spin (rad/s)           of a minus that of b
// with S = 1 in 2D and 3 in 3D. Onset weights count as constant.
class ContactJacobian {
 public:
  // Throws Error if the law has no derivatives.
  ContactJacobian(const ConfiguredLaw& law, int dimension);

  int rows() const { return dimension_ + spins_; }
  int columns() const { return 2 * rows(); }
  // Evaluates a batch of `batch.count` pairs, whose history and outputs stay as they are.
  // inverse_distance: (count) 1/|x_a − x_b| (1/m), by which the normal turns; 0 for a wall.
  // Writes (count, rows, columns) numbers.
  void evaluate(const scree_contact_batch& batch, const double* inverse_distance,
                std::vector<double>& jacobian) const;

 private:
  const ConfiguredLaw& law_;
  int dimension_, spins_;
};

}  // namespace scree
