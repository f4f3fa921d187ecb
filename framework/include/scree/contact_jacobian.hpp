#pragma once

#include <span>
#include <vector>

#include <scree/pair_variation.hpp>
#include <scree/plugin_host.hpp>

namespace scree {

// Independent motions of a touching pair during a step, in the order of the columns of a Jacobian.
enum class PairMotion {
  centres,  // (m) x_a − x_b: changes overlap, normal, separation and tangential increment
  surfaces,  // (m) of a's contact point relative to b's while the centres stay: changes the tangential increment
  rotation_a,  // (rad) of a while the contact points stay: changes its orientation
  rotation_b,  // (rad) likewise of b
  velocity,    // (m/s) of a's contact point relative to b's
  spin         // (rad/s) of a minus spin of b
};
inline constexpr int pair_motions = 6;
// Whether a motion is a rotation or a spin.
constexpr bool is_turning(PairMotion motion) {
  return motion == PairMotion::rotation_a || motion == PairMotion::rotation_b || motion == PairMotion::spin;
}
// D, or, of rotations and spins, S: 1 in 2D and 3 in 3D.
int motion_components(PairMotion motion, int dimension);

// Exact Jacobians of a contact law: the change of force and couple of touching pairs with each motion, on the
// branch (sticking, sliding, ...) on which the law is, with the history before the step. Onset weights count
// as constant. Linear response and stiffness matrices are assembled from them. Rows: force on a (N), D of
// them, then couple (N m), S.
class ContactJacobian {
 public:
  // Throws Error if the law has no derivatives.
  ContactJacobian(const ConfiguredLaw& law, int dimension);

  int rows() const { return dimension_ + spins_; }
  int columns() const { return 3 * rows(); }
  int first(PairMotion motion) const;  // column
  // Evaluates a batch of `batch.count` pairs, whose history and outputs stay as they are.
  // variations: (count) of each pair.
  // Writes (count, rows, columns) numbers.
  void evaluate(const scree_contact_batch& batch, std::span<const PairVariation> variations,
                std::vector<double>& jacobian) const;

 private:
  const ConfiguredLaw& law_;
  int dimension_, spins_;
};

}  // namespace scree
