#include "contacts/contacts.hpp"
#include "ranks/messages.hpp"
#include "ranks/rank_share.hpp"

#include <algorithm>

namespace scree {

namespace {

// A pair of bodies, or of a body and a plane, as messages have it.
struct SentPair {
  std::uint32_t a, b, image;
};

}  // namespace

// Pairs of the tiles of this rank, and what is kept of each: histories, then further numbers.
void Contacts::share(const RankShare& share, const TileOwners* kept, PairColumns& further,
                     std::uint32_t width) {
  std::vector<std::vector<Listed>> pairs(groups_.size());
  std::vector<std::vector<double>> numbers(groups_.size());
  for (std::size_t g = 0; g < groups_.size(); ++g)
    share_group(share, kept, groups_[g], further, width, pairs[g], numbers[g]);
  a.clear(), b.clear(), image.clear();
  std::vector<std::vector<PairColumns::Move>> rows;
  for (std::size_t g = 0; g < groups_.size(); ++g) rows.push_back(fill_unsorted(groups_[g], pairs[g]));
  further.reset(width, padded_size());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    PairGroup& group = groups_[g];
    const std::uint32_t of_history = group.history_width;
    for (const PairColumns::Move& row : rows[g]) {
      const double* const of_pair = numbers[g].data() + std::size_t(row.from) * (of_history + width);
      for (std::uint32_t k = 0; k < of_history; ++k) group.history.column(k)[row.to] = of_pair[k];
      for (std::uint32_t k = 0; k < width; ++k)
        further.column(k)[group.begin + row.to] = of_pair[of_history + k];
    }
  }
  ++revision_;
}

void Contacts::share_group(const RankShare& share, const TileOwners* kept, const PairGroup& group,
                           const PairColumns& further, std::uint32_t width, std::vector<Listed>& pairs,
                           std::vector<double>& numbers) const {
  std::vector<SentPair> own;
  std::vector<double> of_own;
  for (const std::uint32_t tile : share.owners.own())
    for (std::size_t q = group.runs[tile].begin; q < group.runs[tile].end; ++q) {
      own.push_back({a[q], b[q], image[q]});
      for (std::uint32_t k = 0; k < group.history_width; ++k) of_own.push_back(group.history_of(q, k));
      for (std::uint32_t k = 0; k < width; ++k) of_own.push_back(further.column(k)[q]);
    }
  const std::size_t ranks = share.ranks.size(), numbers_of_pair = group.history_width + width;
  const auto pairs_of_ranks = exchange_items(share.ranks, std::vector(ranks, own));
  const auto numbers_of_ranks = exchange_items(share.ranks, std::vector(ranks, of_own));
  for (std::size_t r = 0; r < ranks; ++r)
    for (std::size_t k = 0; k < pairs_of_ranks[r].size(); ++k) {
      const SentPair& pair = pairs_of_ranks[r][k];
      if (kept && !kept->is_own(tiles_.owner(group.planes ? pair.a : std::min(pair.a, pair.b)))) continue;
      pairs.push_back({pair.a, pair.b, std::uint8_t(pair.image), std::uint32_t(pairs.size())});
      const double* const of_pair = numbers_of_ranks[r].data() + k * numbers_of_pair;
      numbers.insert(numbers.end(), of_pair, of_pair + numbers_of_pair);
    }
}

}  // namespace scree
