#include "override_path.hpp"

#include <charconv>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::document {
namespace {

constexpr std::size_t nowhere = std::string_view::npos;
constexpr std::size_t most_segments = 64;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blank);
  if (first == nowhere) return "";
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

// The position of the first of these characters outside quotes.
std::size_t find_unquoted(std::string_view text, std::string_view characters) {
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (quote == 0 && characters.find(text[i]) != nowhere) return i;
    if (text[i] == quote) {
      quote = 0;
    } else if (quote == 0 && (text[i] == '"' || text[i] == '\'')) {
      quote = text[i];
    }
  }
  return nowhere;
}

Error malformed(std::string_view place, std::string_view what) {
  return Error(fmt::format("{}: {}; write the key as in table.key, table[0].key or table.\"odd name\".key",
                           place, what));
}

std::string unquoted(std::string_view name, std::string_view place) {
  const bool opens = !name.empty() && (name.front() == '"' || name.front() == '\'');
  if (!opens) return std::string(name);
  if (name.size() < 2 || name.back() != name.front())
    throw malformed(place, "a quote in the key is not closed");
  return std::string(name.substr(1, name.size() - 2));
}

std::size_t parse_index(std::string_view digits, std::string_view place) {
  std::size_t index = 0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  if (failure != std::errc() || end != digits.data() + digits.size()) {
    throw malformed(place, fmt::format("'{}' is no index from 0", digits));
  }
  return index;
}

OverrideSegment parse_segment(std::string_view text, std::string_view place) {
  OverrideSegment segment;
  const std::size_t bracket = find_unquoted(text, "[");
  const std::string_view name = trimmed(text.substr(0, bracket));
  if (name.empty()) throw malformed(place, "a part of the key is empty");
  segment.name = unquoted(name, place);
  std::string_view rest = bracket == nowhere ? "" : trimmed(text.substr(bracket));
  while (!rest.empty()) {
    const std::size_t close = rest.find(']');
    if (rest.front() != '[' || close == nowhere) throw malformed(place, "a bracket in the key is not closed");
    segment.indices.push_back(parse_index(trimmed(rest.substr(1, close - 1)), place));
    rest = trimmed(rest.substr(close + 1));
  }
  return segment;
}

}  // namespace

OverridePath parse_override(std::string_view text, std::string_view place) {
  const std::size_t equals = find_unquoted(text, "=");
  if (equals == nowhere) throw Error(fmt::format("{}: has no '='; write --set key=value", place));
  OverridePath path;
  path.value = trimmed(text.substr(equals + 1));
  if (path.value.empty())
    throw Error(fmt::format("{}: has no value; write --set key='\"\"' for an empty text", place));
  std::string_view rest = text.substr(0, equals);
  for (;;) {
    const std::size_t dot = find_unquoted(rest, ".");
    if (path.segments.size() == most_segments) throw malformed(place, "the key has too many parts");
    path.segments.push_back(parse_segment(rest.substr(0, dot), place));
    if (dot == nowhere) return path;
    rest.remove_prefix(dot + 1);
  }
}

}  // namespace scree::document
