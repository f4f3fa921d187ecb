#include "numbers.hpp"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

using namespace scree::report;

TEST_CASE("numbers are printed with powers of ten", "[report]") {
  CHECK(number_text(0.25) == "0.25");
  CHECK(number_text(-1.23456e-7, 3) == "−1.23·10⁻⁷");
  CHECK(number_text(NAN) == "–");
  CHECK(number_text(-std::numeric_limits<double>::infinity()) == "−∞");
  CHECK(count_text(1234) == "1234");
  CHECK(count_text(-1234567) == "−1\u202F234\u202F567");
  CHECK(count_text(NAN) == "–");
  CHECK(with_unit(5.793e-6, "s") == "5.793\u00A0µs");
}

TEST_CASE("durations are those of a clock", "[report]") {
  CHECK(duration_text(5.25) == "5.25\u00A0s");
  CHECK(duration_text(125.2) == "2 min 5 s");
  CHECK(duration_text(11530) == "3 h 12 min");
  CHECK(duration_text(NAN) == "–");
}

TEST_CASE("an error has two digits, and its value as many decimals", "[report]") {
  CHECK(with_error(4.8512, 0.0312) == "4.851 ± 0.031");
  CHECK(with_error(-9.6455e-4, 1.24e-5) == "(−9.65 ± 0.12)·10⁻⁴");
  CHECK(with_error(12345, 678) == "(1.234 ± 0.068)·10⁴");
  CHECK(with_error(0, 2e-6) == "(0.0 ± 2.0)·10⁻⁶");
  CHECK(with_error(2.5, NAN) == "2.5");
  CHECK(with_error(NAN, NAN) == "–");
}

TEST_CASE("only a whole number is parsed", "[report]") {
  CHECK(parsed("1.5e-3") == 1.5e-3);
  for (const char* text : {"", "1.5 m", "x"}) CHECK(std::isnan(parsed(text)));
}
