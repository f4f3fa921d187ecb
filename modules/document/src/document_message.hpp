#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <scree/document/message.hpp>

namespace scree::document {

// Shortest decimal that reads back to the same bits: "2e-5", "0.1", "3".
std::string number_text(double value);

// The same as TOML tells it from an integer: "3.0".
std::string toml_number_text(double value);

// A key as a noun: "a radius", "an amplitude", "cycles".
std::string with_article(std::string_view key);

// "a, b or c" with each word in the given quotes.
std::string any_of(const std::vector<std::string>& words, std::string_view quote);

// "a, b, c"
std::string listed(const std::vector<std::string>& words);

// "; did you mean 'friction'?" when a candidate is near, else empty.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace scree::document
