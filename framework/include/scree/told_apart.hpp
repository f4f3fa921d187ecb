#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace scree {

// Two numbers with `digits` significant digits or, if they differ and would read alike, with as many more as
// they need.
inline std::array<std::string, 2> told_apart(double a, double b, int digits = 6) {
  constexpr int all_digits = 17;
  const auto text = [&](double number) {
    char digits_of_number[40];
    std::snprintf(digits_of_number, sizeof(digits_of_number), "%.*g", digits, number);
    return std::string(digits_of_number);
  };
  while (a != b && text(a) == text(b) && digits < all_digits) ++digits;
  return {text(a), text(b)};
}

}  // namespace scree
