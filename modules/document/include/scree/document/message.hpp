#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scree::document {

// What to do about a word that is none of the candidates: "did you mean 'box'?" when one is near, else
// "there are: box, plane".
std::string name_cure(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace scree::document
