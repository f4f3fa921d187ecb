#include <array>
#include <limits>
#include <string>

#include <catch2/catch.hpp>

#include <scree/told_apart.hpp>

using scree::told_apart;
using Pair = std::array<std::string, 2>;

TEST_CASE("two numbers that differ never read alike") {
  CHECK(told_apart(19.5, 20) == Pair{"19.5", "20"});
  CHECK(told_apart(19.9996, 20, 3) == Pair{"19.9996", "20"});
  CHECK(told_apart(1 + std::numeric_limits<double>::epsilon(), 1) == Pair{"1.0000000000000002", "1"});
  CHECK(told_apart(0.1 + 0.2, 0.3) == Pair{"0.30000000000000004", "0.29999999999999999"});
  CHECK(told_apart(2, 2, 3) == Pair{"2", "2"});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(told_apart(nan, nan) == Pair{"nan", "nan"});
}
