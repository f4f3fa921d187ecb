#pragma once

#include <cstring>
#include <type_traits>
#include <vector>

#include <scree/ranks.hpp>

namespace scree {

// Sends items of a plain type to each rank; returns what each has sent.
template <class Item>
std::vector<std::vector<Item>> exchange_items(Ranks& ranks, const std::vector<std::vector<Item>>& outgoing) {
  static_assert(std::is_trivially_copyable_v<Item>);
  std::vector<Ranks::Bytes> sent(outgoing.size());
  for (std::size_t r = 0; r < outgoing.size(); ++r) {
    const std::span<const std::byte> bytes = std::as_bytes(std::span(outgoing[r]));
    sent[r].assign(bytes.begin(), bytes.end());
  }
  std::vector<std::vector<Item>> received;
  for (const Ranks::Bytes& bytes : ranks.exchange(sent)) {
    received.emplace_back(bytes.size() / sizeof(Item));
    if (!bytes.empty()) std::memcpy(received.back().data(), bytes.data(), bytes.size());
  }
  return received;
}

}  // namespace scree
