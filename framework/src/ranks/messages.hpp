#pragma once

#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include <scree/ranks.hpp>

namespace scree {

// Sends items of a plain type to each rank; returns what each has sent. Each list is freed as soon as it is
// copied: together they can be as large as all bodies.
template <class Item>
std::vector<std::vector<Item>> exchange_items(Ranks& ranks, std::vector<std::vector<Item>> outgoing) {
  static_assert(std::is_trivially_copyable_v<Item>);
  std::vector<Ranks::Bytes> sent(outgoing.size());
  for (std::size_t r = 0; r < outgoing.size(); ++r) {
    const std::vector<Item> items = std::exchange(outgoing[r], {});
    const std::span<const std::byte> bytes = std::as_bytes(std::span(items));
    sent[r].assign(bytes.begin(), bytes.end());
  }
  std::vector<Ranks::Bytes> arrived = ranks.exchange(sent);
  sent.clear();
  std::vector<std::vector<Item>> received;
  for (Ranks::Bytes& of_rank : arrived) {
    const Ranks::Bytes bytes = std::exchange(of_rank, {});
    received.emplace_back(bytes.size() / sizeof(Item));
    if (!bytes.empty()) std::memcpy(received.back().data(), bytes.data(), bytes.size());
  }
  return received;
}

}  // namespace scree
