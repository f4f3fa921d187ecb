#pragma once

#include <algorithm>
#include <span>

namespace scree::ranks {

// Calls use(piece) for consecutive pieces of the items, each of at most `longest` items; never for none.
template <class Item, class Use>
void each_piece(std::span<Item> items, std::size_t longest, const Use& use) {
  for (; !items.empty(); items = items.subspan(std::min(longest, items.size())))
    use(items.first(std::min(longest, items.size())));
}

}  // namespace scree::ranks
