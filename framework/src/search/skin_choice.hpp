#pragma once

#include <cstdint>

namespace scree {

// Chooses the skin of a neighbour list for the smallest cost per step: a thin skin lists fewer pairs that do
// not touch, a thick one needs fewer searches. The choice depends on counts, not on measured times, so that
// runs are reproducible.
class SkinChoice {
 public:
  // Properties of a list since its search.
  struct ListStatistics {
    double skin;                      // (m)
    double travelled;                 // (m) largest displacement of a body since the search
    std::uint64_t steps;              // since the search
    double listed, touching, bodies;  // numbers of listed pairs, touching pairs and bodies
  };

  // The first skin and the largest allowed one (m); max_skin = 0: fixed.
  SkinChoice(double skin, double max_skin) : first_(skin), max_skin_(max_skin), fixed_(max_skin <= 0) {}

  double first() const { return first_; }
  bool fixed() const { return fixed_; }
  // No skin (m) that is chosen is larger.
  double largest() const { return fixed_ ? first_ : max_skin_; }
  // A skin that is chosen from now on is not smaller (m), unless the largest allowed one is.
  void keep_above(double skin) { least_ = skin; }
  // Whether the skin should be reviewed after this many steps; the interval grows while nothing changes.
  bool review_due(std::uint64_t steps) const { return !fixed_ && steps == next_review_; }
  // The skin of the next search when the list is used up (m); within a factor of 2 of the last.
  double next_skin(const ListStatistics& list);
  // The better skin (m) if an early search would save more than it costs, assuming that the list would last
  // as long again; otherwise the present skin.
  double reviewed_skin(const ListStatistics& list);

  void transfer(const class StateTransfer& state);

 private:
  double optimal_skin(const ListStatistics& list) const;

  static constexpr std::uint64_t first_review = 32;
  double first_, max_skin_, least_ = 0;
  bool fixed_;
  std::uint64_t next_review_ = first_review;
};

}  // namespace scree
