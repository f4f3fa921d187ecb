#include "nearest_name.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace scree::packing {

namespace {

// Fewest insertions, deletions and replacements of letters that turn a into b.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string suggest_name(std::string_view unknown, std::span<const std::string_view> known) {
  constexpr std::size_t longest_typing_error = 40;
  std::size_t least = std::string_view::npos;
  std::string_view nearest;
  for (const std::string_view name : known.first(unknown.size() < longest_typing_error ? known.size() : 0)) {
    const std::size_t distance = edit_distance(unknown, name);
    if (distance < least) {
      least = distance;
      nearest = name;
    }
  }
  if (!nearest.empty() && least <= std::max<std::size_t>(1, nearest.size() / 2)) {
    return fmt::format("did you mean '{}'?", nearest);
  }
  return fmt::format("known are {}", fmt::join(known, ", "));
}

}  // namespace scree::packing
