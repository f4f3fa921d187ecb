#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scree::scenario {

// Text fit for one line of a message: control characters escaped, cut at longest bytes with "..." behind.
std::string one_line(std::string_view text, std::size_t longest = 80);

// What to do about a word that is none of the candidates: "did you mean 'box'?" when one is near, else
// "there are: box, plane".
std::string name_cure(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace scree::scenario
