#pragma once

#include <cmath>

namespace scree::test {

// How many estimates lie within one and two of their errors.
struct ErrorShares {
  int one = 0, two = 0;
  void add(double off, double error) { one += std::abs(off) < error, two += std::abs(off) < 2 * error; }
  void operator+=(const ErrorShares& more) { one += more.one, two += more.two; }
};

}  // namespace scree::test
