#include "formula_support.hpp"

#include <scree/formula/units.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// The unit of a formula of p.a, p.b, ... with these units.
std::string unit(const std::string& text, const std::vector<std::string>& units) {
  std::string found;
  const std::string error = refusal_of([&] { found = formula::unit_of(formula::parse(text), units); });
  return error == "no error" ? found : error;
}

}  // namespace

TEST_CASE("the unit of a formula follows from those of its columns", "[formula]") {
  CHECK(unit("p.a", {"Pa"}) == "Pa");
  CHECK(unit("-p.a", {"Pa"}) == "Pa");
  CHECK(unit("abs(p.a)", {"Pa"}) == "Pa");
  CHECK(unit("p.a / p.b", {"Pa", "Pa"}) == "");
  CHECK(unit("p.a / p.b", {"Pa", "m"}) == "Pa/m");
  CHECK(unit("p.a / p.b", {"", "m"}) == "1/m");
  CHECK(unit("p.a / p.b", {"", "m/s"}) == "s/m");
  CHECK(unit("p.a / (p.b * p.c)", {"J", "m", "s"}) == "J/(m s)");
  CHECK(unit("p.a * p.b", {"J/(m s)", "m"}) == "J/s");
  CHECK(unit("p.a * p.b", {"m", "m^2"}) == "m^3");
  CHECK(unit("p.a * p.b", {"kg m^2/s", "kg"}) == "kg^2 m^2/s");
  CHECK(unit("p.a ^ 2", {"m/s"}) == "m^2/s^2");
  CHECK(unit("p.a ^ -(1/2)", {"m"}) == "1/m^0.5");
  CHECK(unit("p.a ^ 0", {"m"}) == "");
  CHECK(unit("sqrt(p.a)", {"m^2/s^2"}) == "m/s");
  CHECK(unit("2 ^ p.a", {"rad"}) == "");
  CHECK(unit("p.a ^ p.b", {"", ""}) == "");
  for (const char* text : {"exp(p.a)", "log(p.a)", "log10(p.a)", "sin(p.a)", "cos(p.a)", "tan(p.a)"})
    CHECK(unit(text, {"Pa"}) == "");
  for (const char* text : {"asin(p.a)", "acos(p.a)", "atan(p.a)"}) CHECK(unit(text, {""}) == "rad");
  CHECK(unit("2 * p.a", {"Pa"}) == "Pa");
  CHECK(unit("p.a / 2", {"Pa"}) == "Pa");
  CHECK(unit("2 / p.a", {"rad"}) == "1/rad");
  CHECK(unit("p.a * 2", {"rad"}) == "rad");
  CHECK(unit("pi", {}) == "");
}

TEST_CASE("products of units that cancel are none", "[formula]") {
  CHECK(unit("p.a / p.b", {"Pa", "N/m^2"}) == "");
  CHECK(unit("p.a * p.b / p.c", {"Pa", "m^3", "J"}) == "");
  CHECK(unit("p.a * p.b", {"Hz", "s"}) == "");
  CHECK(unit("p.a / p.b", {"W", "kg m^2/s^3"}) == "");
  CHECK(unit("p.a / p.b", {"N", "kg m/s^2"}) == "");
}

TEST_CASE("a number has the unit of what it is added to", "[formula]") {
  CHECK(unit("p.a - 1e5", {"Pa"}) == "Pa");
  CHECK(unit("1e5 + p.a", {"Pa"}) == "Pa");
  CHECK(unit("max(p.a, 2 * sqrt(3))", {"Pa"}) == "Pa");
  CHECK(unit("1 - p.a", {""}) == "");
}

TEST_CASE("equal units can be added, different ones not", "[formula]") {
  CHECK(unit("p.a + p.b", {"Pa", "Pa"}) == "Pa");
  CHECK(unit("p.a + p.b", {"J/m^3", "Pa"}) == "J/m^3");
  CHECK(unit("p.a - p.b", {"", "rad"}) == "");
  const std::string cure =
      "; give the quantity its unit, as { formula = \"...\", unit = \"Pa\" }, if this is meant";
  CHECK(unit("2 + p.a - p.b", {"Pa", "m"}) == "8: '-' of the units Pa and m" + cure);
  CHECK(unit("p.a + p.b", {"Pa", ""}) == "4: '+' of the units Pa and 1" + cure);
  CHECK(unit("min(p.a, p.b)", {"N", "Pa"}) == "0: 'min' of the units N and Pa" + cure);
  CHECK(unit("p.a ^ p.b", {"m", ""}) == "4: a power of the unit m with an exponent that changes" + cure);
}

TEST_CASE("a unit that cannot be read stands for itself", "[formula]") {
  CHECK(unit("p.a / p.b", {"a/b/c", "a/b/c"}) == "");
  CHECK(unit("p.a / p.b", {"%", "m"}) == "%/m");
  CHECK(unit("p.a * p.b", {"J/(m", "m"}) == "J/(m m");
  CHECK(unit("p.a * p.b", {"m^x", "m"}) == "m m^x");
}
