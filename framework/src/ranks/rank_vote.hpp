#pragma once

#include "ranks/rank_share.hpp"
#include "ranks/rank_sums.hpp"
#include "walls/boundaries.hpp"

#include <cstdint>

namespace scree {

// What all ranks ask each other in each evaluation, within its sums: whether one has failed or has been asked
// to stop, and whether all have moved the walls alike.
class RankVote {
 public:
  // Without ranks (null) nothing is asked.
  RankVote(RankShare* share, const Boundaries& boundaries) : share_(share), boundaries_(boundaries) {}

  void add_to(RankSums& sums);
  // After the sums are closed. Throws what a rank has failed with, or Error with the boundary whose walls
  // differ between ranks.
  void conclude();

 private:
  // Throws Error with the first boundary that ranks have moved differently.
  [[noreturn]] void report_walls() const;

  RankShare* share_;
  const Boundaries& boundaries_;
  std::int64_t interrupted_ = 0, walls_ = 0, walls_of_all_ = 0;
  bool sound_ = true;
};

}  // namespace scree
