#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace scree {

// Sorts items by a key in [0, keys), equal ones in their order: put(item, place) is called for each, and
// those of a key are then at [first[key], first[key + 1]). each(visit) calls visit(item) for all items,
// twice.
template <class Each, class Key, class Put>
void counting_sort(std::size_t keys, std::vector<std::uint32_t>& first, const Each& each, const Key& key,
                   const Put& put) {
  // Counted at key + 2 and filed at where key + 1 begins, which is where the key ends in the end.
  first.assign(keys + 2, 0);
  each([&](const auto& item) { ++first[key(item) + 2]; });
  for (std::size_t k = 0; k <= keys; ++k) first[k + 1] += first[k];
  each([&](const auto& item) { put(item, first[key(item) + 1]++); });
}

}  // namespace scree
