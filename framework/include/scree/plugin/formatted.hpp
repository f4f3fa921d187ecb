#pragma once

#include <cstdio>
#include <string>

namespace scree {

// Text in the format of printf, at most 400 characters: for plug-ins, which do not link a library for it.
template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[400];
  std::snprintf(text, sizeof(text), format, values...);
  return text;
}

}  // namespace scree
