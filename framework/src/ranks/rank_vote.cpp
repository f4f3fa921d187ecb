#include "ranks/rank_vote.hpp"

#include "ranks/messages.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/state_hash.hpp>

namespace scree {

namespace {

// Hashes of the walls, the planes first, in the order of Boundaries::wall_name.
std::vector<std::uint64_t> hashes_of(const Boundaries& boundaries) {
  std::vector<std::uint64_t> hashes;
  for (const scree_plane& plane : boundaries.planes()) {
    StateHash hash;
    for (const double* vector : {plane.point, plane.normal, plane.velocity}) hash.add(vector, 3);
    hashes.push_back(hash.value());
  }
  for (const scree_frame& frame : boundaries.surfaces().frames) {
    StateHash hash;
    for (const double* vector : {frame.position, frame.velocity, frame.spin}) hash.add(vector, 3);
    hash.add(frame.orientation, 4);
    hashes.push_back(hash.value());
  }
  return hashes;
}

}  // namespace

void RankVote::add_to(RankSums& sums) {
  if (!share_) return;
  StateHash hash;
  for (const std::uint64_t wall : hashes_of(boundaries_)) hash.add(wall);
  walls_ = walls_of_all_ = std::int64_t(hash.value());
  sound_ = !share_->failure.any();
  interrupted_ = share_->is_interrupted && share_->is_interrupted();
  sums.all(sound_);
  sums.total(interrupted_);
  sums.total(walls_of_all_);
}

// Of ranks with the same hash, the sum is a multiple of it, modulo 2⁶⁴.
void RankVote::conclude() {
  if (!share_) return;
  share_->other_is_interrupted |= interrupted_ > 0;
  if (!sound_) share_->failure.throw_on_all(share_->ranks);
  if (std::uint64_t(walls_) * share_->ranks.size() != std::uint64_t(walls_of_all_)) report_walls();
}

void RankVote::report_walls() const {
  std::vector<std::vector<std::uint64_t>> hashes(share_->ranks.size());
  hashes[0] = hashes_of(boundaries_);
  const std::vector<std::vector<std::uint64_t>> of_ranks = exchange_items(share_->ranks, hashes);
  if (!share_->is_first()) throw SharedFailure("walls differ between ranks");
  std::size_t wall = 0;
  for (const std::vector<std::uint64_t>& of_rank : of_ranks) {
    const auto differs = std::mismatch(of_rank.begin(), of_rank.end(), of_ranks[0].begin());
    if (differs.first == of_rank.end()) continue;
    wall = std::size_t(differs.first - of_rank.begin());
    break;
  }
  throw Error(
      fmt::format("wall {}", boundaries_.wall_name(wall)),
      "is not at the same place on all ranks: its plug-in does not compute the same from the same numbers",
      "let it read neither time nor random numbers of the machine, or run without --ranks",
      ExitStatus::blow_up);
}

}  // namespace scree
