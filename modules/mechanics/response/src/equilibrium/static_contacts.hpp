#pragma once

#include "equilibrium/pairs_of_law.hpp"

#include <memory>
#include <vector>

namespace scree::response {

// Touching pairs of a packing and pairs that are about to touch, with the histories of their laws, which advance in
// increments of any size: the history at the end of an increment follows from the motion in it, and from the history before.
class StaticContacts {
 public:
  // spins: rotations of a body that count, 0, 1 or 3. Throws Error if a law has no derivatives.
  StaticContacts(const Simulation& simulation, int spins);

  // Finds all pairs within `gap` (m). Pairs that were known keep their histories.
  void find_pairs(const StaticConfiguration& at, double gap);
  // Forces after a motion that ends in `after` (added), and histories and states at its end.
  void evaluate(const StaticConfiguration& after, const StaticMotion& motion, StaticLoads& loads);
  // Negative derivatives of those forces with the end of the motion (added).
  void add_stiffness(Entries& stiffness) const;
  // The last evaluation becomes the beginning of the next increment.
  void commit();

  // Of all pairs, in an order that find_pairs alone changes: at the beginning of the increment, and after the last evaluation.
  std::vector<PairState> states_before() const { return states(&PairsOfLaw::states_before); }
  std::vector<PairState> states_after() const { return states(&PairsOfLaw::states_after); }
  // Pairs whose status in the last evaluation differs from that before.
  std::size_t events() const;
  std::size_t count(PairStatus status) const;  // at the beginning of the increment
  std::vector<bool> touched() const;           // bodies and, behind them, walls, in the last evaluation
  double largest_force() const;                // (N) on a pair in the last evaluation

  std::vector<TouchingPair> touching() const;  // at the beginning of the increment

 private:
  std::vector<PairState> states(const std::vector<PairState>& (PairsOfLaw::*of_law)() const) const;

  const Simulation& simulation_;
  int spins_;
  std::vector<std::unique_ptr<PairsOfLaw>> laws_;
};

}  // namespace scree::response
