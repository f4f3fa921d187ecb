#include "formula_support.hpp"

#include <cmath>

using namespace scree::test;

// The same functions of the same compiler: no tolerance.
TEST_CASE("each function has its value", "[formula]") {
  CHECK(computed("sqrt(p.a)") == std::sqrt(a));
  CHECK(computed("abs(p.b)") == 0.6);
  CHECK(computed("abs(p.a)") == a);
  CHECK(computed("exp(p.a)") == std::exp(a));
  CHECK(computed("log(p.a)") == std::log(a));
  CHECK(computed("log10(p.a)") == std::log10(a));
  CHECK(computed("sin(p.a)") == std::sin(a));
  CHECK(computed("cos(p.a)") == std::cos(a));
  CHECK(computed("tan(p.a)") == std::tan(a));
  CHECK(computed("asin(p.b)") == std::asin(b));
  CHECK(computed("acos(p.b)") == std::acos(b));
  CHECK(computed("atan(p.a)") == std::atan(a));
  CHECK(computed("min(p.a, p.b)") == b);
  CHECK(computed("min(p.b, p.a)") == b);
  CHECK(computed("max(p.a, p.c)") == c);
  CHECK(computed("max(p.c, p.a)") == c);
  CHECK(computed("-p.a") == -a);
}

TEST_CASE("numbers without a value are as a CSV file has them", "[formula]") {
  CHECK(computed("p.a / 0") == INFINITY);
  CHECK(computed("p.b / 0") == -INFINITY);
  CHECK(computed("log(0 * p.a)") == -INFINITY);
  for (const char* text : {"0 * p.a / 0", "sqrt(p.b)", "log(p.b)", "asin(p.a)", "min(sqrt(p.b), 1)",
                           "min(1, sqrt(p.b))", "max(sqrt(p.b), 1)", "max(1, sqrt(p.b))", "p.b ^ 0.5"}) {
    INFO(text);
    CHECK(std::isnan(computed(text)));
  }
}
