#pragma once

#include <string>
#include <string_view>

namespace scree::charts {

// A unit with an SI prefix, for example {1e3, "mm"}.
struct ScaledUnit {
  double factor;  // multiplies values in SI units
  std::string symbol;
};

// Whether a prefix before the unit scales it by the prefix: not before m^2 or kg.
inline bool takes_prefix(std::string_view unit) {
  const std::string_view first = unit.substr(0, unit.find_first_of("/ *"));
  return !first.empty() && first != "1" && !first.starts_with("kg") && first.find('^') == first.npos;
}

// The prefix that gives numbers up to `largest` (SI) from 1 to 1000; none from 0.1 to 1000.
inline ScaledUnit scaled_unit(double largest, const std::string& unit) {
  struct Prefix {
    double factor;
    const char* symbol;
  };
  static constexpr Prefix prefixes[] = {{1e-9, "G"}, {1e-6, "M"}, {1e-3, "k"}, {1, ""},
                                        {1e3, "m"},  {1e6, "µ"},  {1e9, "n"}};
  const bool fits = largest >= 0.1 && (largest < 1000 || unit == "s");  // ks is not in use
  if (!takes_prefix(unit) || !(largest > 0) || fits) return {1, unit};
  for (const Prefix& prefix : prefixes)
    if (largest * prefix.factor >= 1) return {prefix.factor, prefix.symbol + unit};
  return {1, unit};
}

}  // namespace scree::charts
