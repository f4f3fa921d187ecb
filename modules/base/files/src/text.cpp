#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/files/text.hpp>
#include <scree/nearest.hpp>

namespace scree::files {
namespace {

struct Rules {
  std::string_view named, names;  // characters with an escape of one letter, and these letters
  const char* code;               // format of other escapes
  unsigned beyond;                // codes from this one on are also escaped
  std::string_view kept = {};     // characters that stay
};

// In the order of Escapes.
constexpr Rules rules[] = {{"\n\r\t", "nrt", "\\x{:02X}", 0x100},
                           {"\r\t", "rt", "\\x{:02X}", 0x100, "\n"},
                           {"", "", "\\x{:02x}", 0x80},
                           {"\n\"\\", "n\"\\", "\\u{:04X}", 0x100}};

}  // namespace

std::string escaped(std::string_view text, Escapes form) {
  const Rules& rule = rules[static_cast<std::size_t>(form)];
  std::string result;
  for (const char c : text) {
    const unsigned code = static_cast<unsigned char>(c);
    if (rule.kept.find(c) != std::string_view::npos) {
      result += c;
    } else if (const std::size_t at = rule.named.find(c); at != std::string_view::npos) {
      result += '\\';
      result += rule.names[at];
    } else if (code < 0x20 || code == 0x7F || code >= rule.beyond) {
      result += fmt::format(fmt::runtime(rule.code), code);
    } else {
      result += c;
    }
  }
  return result;
}

std::string one_line(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) return escaped(text);
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
  return escaped(text.substr(0, end)) + "...";
}

std::string suggest_name(std::string_view unknown, std::span<const std::string_view> known) {
  const auto near = nearest_word(unknown, {known.begin(), known.end()});
  return near ? fmt::format("did you mean '{}'?", *near)
              : fmt::format("known are {}", fmt::join(known, ", "));
}

}  // namespace scree::files
