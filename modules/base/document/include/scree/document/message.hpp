#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scree::document {

// Cure for a word that is not one of the candidates: "did you mean 'box'?" if a candidate is spelt similarly,
// else "there are: box, plane".
std::string name_cure(std::string_view word, const std::vector<std::string>& candidates);

// Beginning of a cure: "did you mean 'friction'? " if a candidate is spelt similarly, else empty.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

// Shortest decimal that reads back to the same bits: "2e-5", "0.1", "3".
std::string number_text(double value);
// The same as a floating-point number of TOML: "3.0".
std::string toml_number_text(double value);

// A key as a noun, with an article in the singular: "a radius", "an amplitude", "cycles".
std::string with_article(std::string_view key);

// "a, b, c"
std::string listed(const std::vector<std::string>& words);
// The words in double quotes: "a", "b" or "c".
std::string any_of(const std::vector<std::string>& words);

}  // namespace scree::document
