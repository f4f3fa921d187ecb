#include "contacts/contacts.hpp"
#include "ranks/messages.hpp"
#include "ranks/rank_share.hpp"

#include <algorithm>
#include <utility>

namespace scree {

namespace {

// A pair of bodies, or of a body and a plane, as messages have it.
struct SentPair {
  std::uint32_t a, b, image;
};

}  // namespace

// Histories of a pair, then its spot, then further numbers.
struct Contacts::Arrived {
  std::vector<Listed> pairs;
  std::vector<double> numbers;
};

void Contacts::send_to_owners(Ranks& ranks, const TileOwners& owners, PairColumns& further,
                              std::uint32_t width) {
  std::vector<Arrived> arrived;
  for (const PairGroup& group : groups_)
    arrived.push_back(exchange_group(ranks, owners, group, further, width));
  a.clear(), b.clear(), image.clear();
  std::vector<std::vector<PairColumns::Move>> rows;
  for (std::size_t g = 0; g < groups_.size(); ++g)
    rows.push_back(fill_unsorted(groups_[g], arrived[g].pairs));
  further.reset(width, padded_size());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    PairGroup& group = groups_[g];
    for (const PairColumns::Move& row : rows[g]) {
      const double* number = arrived[g].numbers.data() +
                             std::size_t(row.from) * (group.history_width + group.spot_width + width);
      for (std::uint32_t k = 0; k < group.history_width; ++k) group.history.column(k)[row.to] = *number++;
      for (std::uint32_t k = 0; k < group.spot_width; ++k) group.spots.column(k)[row.to] = *number++;
      for (std::uint32_t k = 0; k < width; ++k) further.column(k)[group.begin + row.to] = *number++;
    }
  }
  ++revision_;
}

Contacts::Arrived Contacts::exchange_group(Ranks& ranks, const TileOwners& owners, const PairGroup& group,
                                           const PairColumns& further, std::uint32_t width) const {
  std::vector<std::vector<SentPair>> pairs(ranks.size());
  std::vector<std::vector<double>> numbers(ranks.size());
  for (std::size_t tile = 0; tile < group.runs.size(); ++tile) {
    const std::uint32_t rank = owners.rank_of(tile);
    for (std::size_t q = group.runs[tile].begin; q < group.runs[tile].end; ++q) {
      pairs[rank].push_back({a[q], b[q], image[q]});
      for (std::uint32_t k = 0; k < group.history_width; ++k) numbers[rank].push_back(group.history_of(q, k));
      for (std::uint32_t k = 0; k < group.spot_width; ++k)
        numbers[rank].push_back(group.spots.column(k)[q - group.begin]);
      for (std::uint32_t k = 0; k < width; ++k) numbers[rank].push_back(further.column(k)[q]);
    }
  }
  Arrived arrived;
  for (const std::vector<SentPair>& of_rank : exchange_items(ranks, std::move(pairs)))
    for (const SentPair& pair : of_rank)
      arrived.pairs.push_back(
          {pair.a, pair.b, std::uint8_t(pair.image), std::uint32_t(arrived.pairs.size())});
  for (const std::vector<double>& of_rank : exchange_items(ranks, std::move(numbers)))
    arrived.numbers.insert(arrived.numbers.end(), of_rank.begin(), of_rank.end());
  return arrived;
}

}  // namespace scree
