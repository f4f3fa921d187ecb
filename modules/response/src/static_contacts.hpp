#pragma once

#include "entries.hpp"
#include "static_configuration.hpp"

#include <memory>
#include <vector>

namespace scree::response {

// Force (N) and torque (N m) on each body and, behind them, each wall.
struct StaticLoads {
  std::vector<Vec3> force, torque;
};

// State of a pair: what changes it is an event.
enum class PairStatus : std::uint8_t { open, sticks, slides };

// Touching pairs of a packing and pairs that are about to touch, with the histories of their laws, which advance in
// increments of any size: the history at the end of an increment follows from the motion in it, and from the history before.
class StaticContacts {
 public:
  // spins: rotations of a body that count, 0, 1 or 3. Throws Error if a law has no derivatives.
  StaticContacts(const Simulation& simulation, int spins);
  ~StaticContacts();

  // Finds all pairs within `gap` (m). Pairs that were known keep their histories.
  void find_pairs(const StaticConfiguration& at, double gap);
  // Forces after a motion that ends in `after` (added), and histories and states at its end.
  void evaluate(const StaticConfiguration& after, const StaticMotion& motion, StaticLoads& loads);
  // Negative derivatives of those forces with the end of the motion (added).
  void add_stiffness(Entries& stiffness) const;
  // The last evaluation becomes the beginning of the next increment.
  void commit();

  // Pairs whose states in the last evaluation differ from those before.
  std::size_t events() const;
  std::size_t count(PairStatus status) const;  // at the beginning of the increment
  double largest_force() const;                // (N) on a pair in the last evaluation

  // For each pair that touches at the beginning of the increment, its ends as in ContactList, its law and its history.
  struct Touching {
    std::uint32_t a, b, law;
    const double* history;
    std::uint32_t width;
  };
  std::vector<Touching> touching() const;

 private:
  class LawPairs;
  const Simulation& simulation_;
  int spins_;
  std::vector<std::unique_ptr<LawPairs>> laws_;
};

}  // namespace scree::response
