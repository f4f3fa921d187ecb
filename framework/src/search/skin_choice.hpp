#pragma once

#include <cstdint>

namespace scree {

// Chooses the skin of a neighbour list so that steps cost least: a thin one lists fewer pairs that do not
// touch, a thick one is searched less often. Decides by counts alone, never by the clock, so that a run does
// the same each time.
class SkinChoice {
 public:
  // What a list was found to be like.
  struct ListStatistics {
    double skin;          // (m)
    double travelled;     // (m) the longest way of a body since the search
    std::uint64_t steps;  // since the search
    double listed, touching, bodies;
  };

  // The skin at the start and the max_skin that it may become (m); 0 keeps it.
  SkinChoice(double skin, double max_skin) : first_(skin), max_skin_(max_skin), fixed_(max_skin <= 0) {}

  double first() const { return first_; }
  bool fixed() const { return fixed_; }
  // Whether to look at the list again after this many steps: ever more rarely.
  bool due(std::uint64_t steps) const { return !fixed_ && steps == next_review_; }
  // The skin to search with now, of a list that is used up; within a factor of 2 of the last.
  double after(const ListStatistics& list);
  // The skin to search with although the list is not used up yet, or that of the list to keep it. Searches
  // if what its pairs cost is more than the search, provided that the list lives as long again.
  double review(const ListStatistics& list);

 private:
  double best(const ListStatistics& list) const;

  static constexpr std::uint64_t first_review = 32;
  double first_, max_skin_;
  bool fixed_;
  std::uint64_t next_review_ = first_review;
};

}  // namespace scree
