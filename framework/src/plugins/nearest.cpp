#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include <scree/nearest.hpp>

namespace scree {
namespace {

constexpr std::size_t shortest_part = 3;
constexpr std::size_t largest_distance = 4;

std::string folded(std::string_view word) {
  std::string result(word);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '-') c = '_';
  }
  return result;
}

// Restricted Damerau–Levenshtein distance: no letter is edited twice.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

bool one_is_prefix(std::string_view a, std::string_view b) {
  const std::size_t shorter = std::min(a.size(), b.size());
  return shorter >= shortest_part && a.substr(0, shorter) == b.substr(0, shorter);
}

// "friction" of "static_friction".
bool one_is_last_part(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  return a.size() >= shortest_part && b.size() > a.size() && b.ends_with(a) &&
         b[b.size() - a.size() - 1] == '_';
}

}  // namespace

std::optional<std::string> nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string given = folded(word);
  std::optional<std::string> best, prefix, part;
  std::size_t best_distance = 0;
  for (const std::string& candidate : candidates) {
    const std::string offered = folded(candidate);
    if (!prefix && one_is_prefix(given, offered)) prefix = candidate;
    if (!part && one_is_last_part(given, offered)) part = candidate;
    const auto [shorter, longer] = std::minmax({given.size(), offered.size()});
    const std::size_t limit = std::min(longer / 3, largest_distance);
    if (longer - shorter > limit) continue;
    const std::size_t distance = edit_distance(given, offered);
    if (distance > limit || (best && distance >= best_distance)) continue;
    best = candidate;
    best_distance = distance;
  }
  return best ? best : prefix ? prefix : part;
}

}  // namespace scree
