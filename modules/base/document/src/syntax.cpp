#include "tree.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::document {
namespace {

// Maximum nesting depth of tables and arrays in a document.
constexpr int deepest_nesting = 64;
// Maximum number of parts of a dotted key, including the keys around it: well above deepest_nesting, which is
// checked after parsing with an exact place, and well below the number at which the parser overflows the
// stack.
constexpr int most_key_parts = 1000;
constexpr std::size_t longest_complaint = 200;

struct Cure {
  std::string_view sign;  // part of the parser's message
  std::string_view cure;
};

// The first match is used, so specific entries precede general ones.
constexpr Cure cures[] = {
    {"redefine existing table", "merge the two tables, or write [[name]] for each entry of a list"},
    {"redefine existing", "keep one of the two"},
    {"is given twice", "keep one of the two"},
    {"determine value type", "give a number, true, false, an [array] or a \"string\" in quotes"},
    {"parsing boolean", "write true or false, or put the word in quotes"},
    {"end-of-file", "close the bracket, brace or quote that is open there"},
    {"utf-8", "save the file as UTF-8 text"},
    {"leading zeroes", "write the number without leading zeros"},
    {"not representable", "give a number that fits 64 bits"},
    {"could not be interpreted", "give a number of magnitude below 1.8e308"},
    {"underscores", "put underscores between digits only"},
    {"digit, saw '.'", "put a digit on both sides of the decimal point, such as 0.5"},
    {"digit, saw '\\", "put a digit behind the decimal point or exponent, such as 1.0"},
    {"digit", "write a plain number such as 2.5e-3, without a unit (all units are SI)"},
    {"comment or whitespace, saw ','", "use a decimal point, one value for each key, and [ ] for several"},
    {"comment or whitespace", "put each key = value on a line of its own"},
    {"expected '='", "write key = value"},
    {"expected value", "give the value behind the = on the same line"},
    {"inline table", "write an inline table on one line, { a = 1, b = 2 }"},
    {"table header", "write [name] or [[name]] on a line of its own"},
    {"control characters", "close the quote on the same line, or use \"\"\" for several lines"},
    {"escape sequence", "write \\\\ for a backslash, or use 'single quotes'"},
    {"nested value depth", "flatten the arrays"},
    {"keys, tables", "write key = value, [table], [[entry of a list]] or # comment"},
};

// The key of the value at a place, since the parser garbles quoted keys in its messages.
std::string key_before(std::string_view text, const toml::source_region& region) {
  for (toml::source_index line = 1; line < region.begin.line && !text.empty(); ++line)
    text.remove_prefix(std::min(text.size(), text.find('\n') + 1));
  std::string_view key = text.substr(0, region.begin.column);
  key = key.substr(0, key.rfind('='));
  if (key.find('{') != std::string_view::npos) key.remove_prefix(key.find_last_of("{,") + 1);
  const std::size_t first = std::min(key.find_first_not_of(" \t"), key.size());
  return std::string(key.substr(first, key.find_last_not_of(" \t") + 1 - first));
}

// An error of the TOML parser as "place: not valid TOML: what; cure".
Error no_toml(std::string_view name, std::string_view text, const toml::parse_error& error) {
  constexpr std::string_view opening = "Error while parsing ";
  std::string_view description = error.description();
  const bool of_key =
      description.starts_with("Error while parsing key-value pair: cannot redefine existing ");
  const std::string repeated =
      of_key ? fmt::format("the key {} is given twice", key_before(text, error.source())) : "";
  if (of_key && description.find("existing table") == std::string_view::npos) description = repeated;
  std::string_view cure = "correct the line by the rules of TOML (toml.io)";
  for (const Cure& candidate : cures) {
    if (description.find(candidate.sign) == std::string_view::npos) continue;
    cure = candidate.cure;
    break;
  }
  if (description.starts_with(opening)) description.remove_prefix(opening.size());
  return Error(place_text(name, error.source()),
               fmt::format("not valid TOML: {}", files::one_line(description, longest_complaint)),
               std::string(cure));
}

Error too_deep(const std::string& place) {
  return Error(place, fmt::format("tables or arrays more than {} deep", deepest_nesting), "flatten them");
}

bool is_key_character(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '-' ||
         static_cast<unsigned char>(c) >= 0x80;
}

// End of the token that begins at a position: a comment, string, bare word or single character.
std::size_t token_end(std::string_view text, std::size_t at) {
  const char first = text[at];
  if (first == '#') return std::min(text.find('\n', at), text.size());
  if (first == '"' || first == '\'') {
    const bool triple = text.substr(at + 1, 2) == std::string(2, first);
    const std::string_view close = text.substr(at, triple ? 3 : 1);
    for (std::size_t i = at + close.size(); i < text.size(); ++i) {
      if (text[i] == '\n' && !triple) return i;
      if (text[i] == '\\' && first == '"')
        ++i;
      else if (text.substr(i, close.size()) == close)
        return triple ? std::min(text.find_first_not_of(first, i), text.size()) : i + 1;
    }
    return text.size();
  }
  std::size_t end = at + 1;
  while (is_key_character(first) && end < text.size() && is_key_character(text[end])) ++end;
  return end;
}

// Line of the first dotted key that has, including the keys around it, more than most_key_parts parts. The
// TOML parser nests one table per part and would overflow the stack.
std::optional<toml::source_region> find_endless_key(std::string_view text) {
  struct Level {
    int above, key;  // dots in the keys around the bracket, and in the key whose value is being read
  };
  std::vector<Level> levels = {{0, 0}};
  int dots = 0;
  bool after_word = false;
  for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
    end = token_end(text, at);
    const char c = text[at];
    Level& level = levels.back();
    if (c == ' ' || c == '\t') continue;
    const bool word = is_key_character(c) || c == '"' || c == '\'';
    if (c == '.') {
      ++dots;
    } else if (c == '=') {
      level.key = std::exchange(dots, 0);
    } else if (!word || after_word) {
      dots = 0;
    }
    if (c == ',' || (c == '\n' && levels.size() == 1)) level.key = 0;
    after_word = word;
    if (level.above + level.key + dots > most_key_parts) {
      const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n');
      return toml::source_region{{static_cast<toml::source_index>(line), 1}, {}, {}};
    }
    if (c == '[' || c == '{') levels.push_back({level.above + level.key, 0});
    if ((c == ']' || c == '}') && levels.size() > 1) levels.pop_back();
  }
  return std::nullopt;
}

// Refuses deep nesting, and texts with a character 0, which as the end of a C string would hide the rest of a
// path.
void check_nodes(std::string_view name, const toml::node& node, int depth) {
  if (depth > deepest_nesting) throw too_deep(place_text(name, node.source()));
  if (const auto* text = node.as_string(); text && text->get().find('\0') != std::string::npos)
    throw Error(place_text(name, node.source()),
                fmt::format("the text \"{}\" has a character U+0000", files::one_line(text->get())),
                "remove it");
  each_child(node, [&](const toml::node& child) { check_nodes(name, child, depth + 1); });
}

// Whether a text that is no TOML is a number beyond the range of numbers.
bool is_beyond_range(std::string_view text) {
  const std::string number(text);
  char* end = nullptr;
  errno = 0;
  if (number.find_first_not_of("+-0123456789") == std::string::npos)
    std::strtoll(number.c_str(), &end, 10);
  else
    std::strtod(number.c_str(), &end);
  return errno == ERANGE && *end == 0;
}

}  // namespace

toml::table parse_text(std::string_view text, std::string_view name) {
  if (const auto region = find_endless_key(text)) throw too_deep(place_text(name, *region));
  try {
    toml::table root = toml::parse(text);
    check_nodes(name, root, 0);
    return root;
  } catch (const toml::parse_error& error) {
    throw no_toml(name, text, error);
  }
}

toml::table parse_value(std::string_view text, const std::string& place) {
  if (find_endless_key(text)) throw too_deep(place);
  try {
    toml::table parsed = toml::parse("value = " + std::string(text), place);
    if (parsed.size() == 1) {
      check_nodes(place, *parsed.get("value"), 0);
      return parsed;
    }
  } catch (const toml::parse_error& error) {
    const bool meant_as_toml = std::string_view("[{\"'").find(text.front()) != std::string_view::npos;
    if (meant_as_toml || is_beyond_range(text)) throw no_toml(place, text, error);
  }
  return toml::parse("value = " + quoted_text(text), place);
}

}  // namespace scree::document
