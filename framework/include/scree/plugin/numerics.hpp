#pragma once

#include <cstdint>

#include <scree/plugin/abi.h>

namespace scree::detail {

// Whether the compiler fuses products and sums of its own accord: no macro shows it. A square minus the same
// square, rounded, is 0, but not if the first is not rounded.
inline bool contracts() {
  volatile double factor = 1 + 0x1p-30;
  const double first = factor, second = factor;
  volatile double rounded = first * first;
  const double difference = second * second - rounded;
  return difference != 0;
}

// Settings of this build that change values, for the manifest.
inline std::uint32_t numeric_settings() {
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    defined(__NO_SIGNED_ZEROS__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
  constexpr std::uint32_t fast = SCREE_FAST_MATH;
#else
  constexpr std::uint32_t fast = 0;
#endif
  return fast | (contracts() ? std::uint32_t(SCREE_CONTRACTED) : 0);
}

}  // namespace scree::detail
