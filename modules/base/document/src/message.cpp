#include <cmath>

#include <fmt/format.h>

#include <scree/document/message.hpp>
#include <scree/files/text.hpp>
#include <scree/nearest.hpp>

namespace scree::document {

std::string name_cure(std::string_view word, const std::vector<std::string>& candidates) {
  if (const auto near = nearest_word(word, candidates))
    return fmt::format("did you mean '{}'?", files::one_line(*near));
  return candidates.empty() ? "there are none" : "there are: " + listed(candidates);
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates) {
  const auto near = nearest_word(word, candidates);
  return near ? fmt::format("did you mean '{}'? ", files::one_line(*near)) : "";
}

std::string number_text(double value) {
  std::string digits = fmt::format("{}", value);
  const std::size_t exponent = digits.find('e');
  if (exponent == std::string::npos) return digits;
  const std::size_t first = exponent + 2;
  if (digits[first] == '0' && first + 1 < digits.size()) digits.erase(first, 1);
  return digits;
}

std::string toml_number_text(double value) {
  if (std::isnan(value)) return "nan";
  const std::string digits = number_text(value);
  return digits.find_first_of(".ein") == std::string::npos ? digits + ".0" : digits;
}

std::string with_article(std::string_view key) {
  std::string noun = files::one_line(key);
  for (char& c : noun) {
    if (c == '_') c = ' ';
  }
  const auto ends_with = [&](std::string_view end) { return noun.ends_with(end); };
  const bool plural = ends_with("s") && !ends_with("ss") && !ends_with("us") && !ends_with("is");
  if (plural || noun.empty()) return noun;
  const bool vowel = std::string_view("aeio").find(noun[0]) != std::string_view::npos;
  return (vowel ? "an " : "a ") + noun;
}

std::string listed(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string any_of(const std::vector<std::string>& words) {
  std::string result;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) result += i + 1 == words.size() ? " or " : ", ";
    result += fmt::format("\"{}\"", files::one_line(words[i]));
  }
  return result;
}

}  // namespace scree::document
