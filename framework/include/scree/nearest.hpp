#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scree {

// The candidate that the user most likely meant by word, or nothing when none is near; the first of equals.
// Near: an edit distance (insert, delete, replace, swap neighbours) of at most a third of the longer word and
// 4, or one of the two begins with the other from 3 letters on. Case is ignored and '-' reads as '_'.
std::optional<std::string> nearest_word(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace scree
