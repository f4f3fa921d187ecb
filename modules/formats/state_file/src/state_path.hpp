#pragma once

#include <string_view>

namespace scree::state_file {

// Whether a text is a path of a State: names of lower-case letters, digits and '_', separated by '/'.
inline bool is_state_path(std::string_view path) {
  char before = '/';
  for (const char c : path) {
    const bool named = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    if (!named && (c != '/' || before == '/')) return false;
    before = c;
  }
  return before != '/';
}

}  // namespace scree::state_file
