#pragma once

#include "bodies/body_range.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace scree {

// Rearranges rows of `width` numbers: row i becomes what row from[i] was, for i in these ranges. Other rows
// are 0 afterwards, without being written if the container leaves new elements as they are.
template <class Container>
void rearrange_rows(Container& numbers, std::size_t width, const std::vector<std::uint32_t>& from,
                    std::span<const BodyRange> kept) {
  if (numbers.empty()) return;
  Container rearranged(numbers.size());
  for (const BodyRange& range : kept)
    for (std::size_t i = range.begin; i < range.end; ++i)
      for (std::size_t k = 0; k < width; ++k) rearranged[i * width + k] = numbers[from[i] * width + k];
  numbers = std::move(rearranged);
}

}  // namespace scree
