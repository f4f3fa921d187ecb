#include "contacts/contacts.hpp"
#include "ranks/messages.hpp"
#include "ranks/rank_share.hpp"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include <scree/state_hash.hpp>

namespace scree {

namespace {

// Ranks send the histories of pairs to the first rank for so many bodies at a time: it has no room for all.
constexpr std::size_t bodies_at_once = std::size_t(1) << 18;

// What is not 0: a pair, by the numbers of its partners, and a number of its history.
struct KeptNumber {
  std::uint64_t pair, column;
  double value;
};

void add_kept(std::vector<KeptNumber>& numbers, const Contacts& contacts, const PairGroup& group,
              std::size_t pair, const BodyOrder& order) {
  constexpr std::uint32_t spots_from = 28;  // bits; walls have lower numbers
  const std::uint32_t b = group.planes ? contacts.b[pair] | spot_of_image(contacts.image[pair]) << spots_from
                                       : order.number(contacts.b[pair]);
  const auto add = [&](std::uint32_t column, double value) {
    if (value != 0)
      numbers.push_back({(std::uint64_t(order.number(contacts.a[pair])) << 32) | b, column, value});
  };
  for (std::uint32_t k = 0; k < group.history_width; ++k) add(k, group.history_of(pair, k));
  for (std::uint32_t k = 0; k < group.spot_width; ++k)
    add(group.history_width + k, group.spots.column(k)[pair - group.begin]);
}

// On the first rank: of all ranks, in scene order.
std::vector<KeptNumber> joined(Ranks& ranks, std::vector<KeptNumber> numbers) {
  std::vector<std::vector<KeptNumber>> sent(ranks.size());
  sent[0] = std::move(numbers);
  std::vector<KeptNumber> all;
  for (const std::vector<KeptNumber>& of_rank : exchange_items(ranks, std::move(sent)))
    all.insert(all.end(), of_rank.begin(), of_rank.end());
  std::sort(all.begin(), all.end(), [](const KeptNumber& one, const KeptNumber& other) {
    return std::tie(one.pair, one.column) < std::tie(other.pair, other.column);
  });
  return all;
}

}  // namespace

void Contacts::add_to_hash(StateHash& hash, const BodyOrder& order, RankShare* share) const {
  for (const PairGroup& group : groups_) {
    const std::vector<std::size_t> pairs = in_scene_order(group, order);
    std::size_t next = 0;
    for (std::size_t begin = 0; begin < tiles_.size(); begin += bodies_at_once) {
      std::vector<KeptNumber> numbers;
      for (; next < pairs.size() && order.number(a[pairs[next]]) < begin + bodies_at_once; ++next)
        add_kept(numbers, *this, group, pairs[next], order);
      if (share) numbers = joined(share->ranks, std::move(numbers));
      for (const KeptNumber& number : numbers) {
        hash.add(number.pair);
        hash.add(number.column);
        hash.add(number.value);
      }
    }
  }
}

}  // namespace scree
