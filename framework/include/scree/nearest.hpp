#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scree {

// The candidate closest to a mistyped word, or nothing if none is close; the first of several equally close
// ones. Close: an edit distance (insert, delete, replace, swap adjacent letters) of at most a third of the
// longer word and at most 4, or one word is a prefix of at least 3 letters of the other, or its last part
// after a '_'. Case is ignored; '-' equals '_'.
std::optional<std::string> nearest_word(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace scree
