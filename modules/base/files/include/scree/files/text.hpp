#pragma once

#include <span>
#include <string>
#include <string_view>

namespace scree::files {

// How escaped() writes control characters.
enum class Escapes {
  message,  // \n, \r, \t, \x1B; bytes beyond ASCII are unchanged
  lines,    // the same except for line breaks, for reports of several lines
  bytes,    // \x0a, \x1b; also every byte beyond ASCII, for text of unknown encoding
  toml      // as in a string in double quotes in TOML: \n, \", \\, \u001B
};

// Text with control characters escaped.
std::string escaped(std::string_view text, Escapes form = Escapes::message);

// Text for one line of a message: control characters escaped; after `longest` bytes it is cut and ends with
// "...".
std::string one_line(std::string_view text, std::size_t longest = 80);

// Cure for an unknown name: the nearest known name, or all known names if none is near.
std::string suggest_name(std::string_view unknown, std::span<const std::string_view> known);

}  // namespace scree::files
