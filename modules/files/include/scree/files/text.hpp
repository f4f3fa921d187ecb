#pragma once

#include <string>
#include <string_view>

namespace scree::files {

// How escaped() writes what would upset a line.
enum class Escapes {
  message,  // \n, \r, \t, \x1B; what is beyond ASCII stays
  bytes,    // \x0a, \x1b, and so every byte beyond ASCII, for text of unknown encoding
  toml      // as between double quotes in TOML: \n, \", \\, \u001B
};

// Text without control characters.
std::string escaped(std::string_view text, Escapes form = Escapes::message);

// Text fit for one line of a message: control characters escaped, cut at `longest` bytes with "..." behind.
std::string one_line(std::string_view text, std::size_t longest = 80);

}  // namespace scree::files
