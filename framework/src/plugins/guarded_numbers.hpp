#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>

namespace scree {

// Numbers behind an array that a plug-in fills, which it must not change.
inline constexpr std::size_t guard_size = 4;
inline constexpr double guard = -6.02214076e-123;

inline std::vector<double> guarded(std::size_t size) {
  std::vector<double> numbers(size, 0.0);
  numbers.insert(numbers.end(), guard_size, guard);
  return numbers;
}

// Throws Error if the plug-in has changed them; what: "state".
inline void check_guard(const std::vector<double>& numbers, const char* plugin, const char* what) {
  if (std::all_of(numbers.end() - guard_size, numbers.end(), [](double x) { return x == guard; })) return;
  throw Error(fmt::format("plug-in {}: writes beyond the {} of its {}; declare as many as it writes", plugin,
                          counted(numbers.size() - guard_size, "number"), what));
}

}  // namespace scree
