#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scree::document {

// What to do about a word that is none of the candidates: "did you mean 'box'?" when one is near, else
// "there are: box, plane".
std::string name_cure(std::string_view word, const std::vector<std::string>& candidates);

// "; did you mean 'friction'?" when a candidate is near, else ";".
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

// Shortest decimal that reads back to the same bits: "2e-5", "0.1", "3".
std::string number_text(double value);
// The same as TOML tells it from an integer: "3.0".
std::string toml_number_text(double value);

// A key as a noun: "a radius", "an amplitude", "cycles".
std::string with_article(std::string_view key);

// "a, b, c"
std::string listed(const std::vector<std::string>& words);
// "a", "b" or "c", each in double quotes.
std::string any_of(const std::vector<std::string>& words);

}  // namespace scree::document
