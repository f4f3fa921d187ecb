#include <catch2/catch.hpp>

#include <scree/charts/scaled_unit.hpp>

using namespace scree::charts;

TEST_CASE("units have a prefix where it keeps their meaning", "[charts]") {
  const auto symbol = [](double largest, const char* unit) { return scaled_unit(largest, unit).symbol; };
  CHECK(symbol(0.05, "m") == "mm");
  CHECK(scaled_unit(0.05, "m").factor == 1e3);
  CHECK(symbol(2e4, "Pa") == "kPa");
  CHECK(symbol(3e9, "Pa") == "GPa");
  CHECK(symbol(2e-6, "s") == "µs");
  CHECK(symbol(5e4, "s") == "s");
  CHECK(symbol(0.05, "m/s") == "mm/s");
  for (const char* unit : {"m^2", "m^3", "kg", "kg/m^3", "1/s", ""}) CHECK(symbol(1e-5, unit) == unit);
  CHECK(symbol(0, "m") == "m");
}
