#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace scree {

// A number with its noun, in the singular for 1: "1 wall", "2 walls". The plural is noun + "s" unless it is
// given. A verb may follow in both: counted(n, "mode is", "modes are").
inline std::string counted(std::size_t count, std::string_view noun, std::string_view plural = "") {
  std::string text = std::to_string(count) + ' ';
  if (count == 1 || plural.empty()) text += noun;
  if (count != 1) text += plural.empty() ? "s" : plural;
  return text;
}

}  // namespace scree
