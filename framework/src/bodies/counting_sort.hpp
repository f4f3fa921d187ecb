#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace scree {

// Stable sort of items by a key in [0, keys). each(visit) must call visit(item) for all items; it is called
// twice. put(item, index) is called for each item with its sorted index; the items of a key are then at
// [first[key], first[key + 1]).
template <class Each, class Key, class Put>
void counting_sort(std::size_t keys, std::vector<std::uint32_t>& first, const Each& each, const Key& key,
                   const Put& put) {
  // Counts at key + 2; first[key + 1] then serves as insertion index of the key, and ends as the end of its
  // items.
  first.assign(keys + 2, 0);
  each([&](const auto& item) { ++first[key(item) + 2]; });
  for (std::size_t k = 0; k <= keys; ++k) first[k + 1] += first[k];
  each([&](const auto& item) { put(item, first[key(item) + 1]++); });
}

}  // namespace scree
