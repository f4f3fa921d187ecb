#pragma once

#include <limits>

namespace scree::test {

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();
inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace scree::test
