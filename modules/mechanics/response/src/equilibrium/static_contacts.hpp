#pragma once

#include "equilibrium/pairs_of_law.hpp"

#include <cstdint>
#include <memory>
#include <vector>

#include <scree/pair_search.hpp>

namespace scree::response {

// Pairs of a packing that touch or are about to touch, with the histories of their laws, which advance in
// increments of any size: the history at the end of an increment follows from the history before it and the
// motion in it.
class StaticContacts {
 public:
  // spins: number of rotations of a body, 0, 1 or 3. Throws Error if a law has no derivatives.
  StaticContacts(const Simulation& simulation, int spins);

  // Lists all pairs within `gap` (m). Pairs that were listed before keep their histories.
  void find_pairs(const StaticConfiguration& at, double gap);
  // Adds the forces after a motion that ends in `after`, and computes histories and states there.
  void evaluate(const StaticConfiguration& after, const StaticMotion& motion, StaticLoads& loads);
  // Adds the negative derivatives of these forces by the end of the motion.
  void add_stiffness(Entries& stiffness) const;
  // Makes the last evaluation the beginning of the next increment.
  void commit();

  // States of all pairs at the beginning of the increment and after the last evaluation, in an order that
  // only find_pairs changes.
  std::vector<PairState> states_before() const { return states(&PairsOfLaw::states_before); }
  std::vector<PairState> states_after() const { return states(&PairsOfLaw::states_after); }
  // Number of pairs whose status in the last evaluation differs from that at the beginning of the increment.
  std::size_t events() const;
  std::size_t count(PairStatus status) const;  // at the beginning of the increment
  std::vector<bool> touched() const;           // bodies, then walls, in the last evaluation
  double largest_force() const;                // (N) on a pair in the last evaluation

  std::vector<ContactHistory> touching() const;  // at the beginning of the increment

 private:
  using StatesOfLaw = const std::vector<PairState>& (PairsOfLaw::*)() const;
  std::vector<PairState> states(StatesOfLaw states_of) const;
  // Place in laws_ of the pairs of a law with a partner.
  std::size_t place_of(std::uint32_t law, std::uint32_t b) const;
  // The bodies as spheres in the periodic domain.
  std::vector<Sphere> spheres(const StaticConfiguration& at) const;

  const Simulation& simulation_;
  std::vector<std::unique_ptr<PairsOfLaw>> laws_;  // with bodies and planes, then with surfaces
  ThreadPool threads_{1};
  PairSearch search_{PairSearch::Images::nearest};
};

}  // namespace scree::response
