#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <scree/pair_search.hpp>

namespace scree {

// Searches among bodies that move little from one search to the next: a grid finds candidates with a margin
// on the skin, and searches select from these until bodies may have moved through the margin.
// PairSearch::find would give the same pairs in the same order.
class RepeatedSearch {
 public:
  // moved: a bound of the largest displacement of a body since the last search (m), without folding; infinite
  // if it is unknown or if the number, the order, the radii of the bodies or the domain have changed. Valid
  // until the next search. Errors as of PairSearch::find.
  // complete: skin (m) up to which all bodies that have pairs are given.
  const std::vector<NeighbourPair>& find(std::span<const Sphere> bodies, int dimension, const Domain& domain,
                                         double skin, double moved, ThreadPool& threads,
                                         double complete = std::numeric_limits<double>::infinity());

  // Searches by the grid so far.
  std::size_t grid_searches() const { return grid_searches_; }

 private:
  void find_candidates(std::span<const Sphere> bodies, int dimension, const Domain& domain, double skin,
                       double complete, ThreadPool& threads);
  void select(std::span<const Sphere> bodies, const Domain& domain, double skin, ThreadPool& threads);
  void adapt_margin();

  PairSearch search_;
  const std::vector<NeighbourPair>* candidates_ = nullptr;
  double covered_ = 0;          // skin up to which no pair is missing in the candidates (m)
  double margin_per_skin_ = 0;  // of the next candidates
  std::size_t grid_searches_ = 0, found_last_ = 0;
  std::vector<NeighbourPair> selected_;
  std::vector<NeighbourPair*> ends_;  // of the pairs that each share of the candidates selects
};

}  // namespace scree
