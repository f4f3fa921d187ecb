#include <catch2/catch.hpp>

#include <scree/charts/ticks.hpp>

using namespace scree::charts;

TEST_CASE("ticks are round numbers within the range", "[charts]") {
  CHECK(linear_ticks(0, 1, 5).labels == std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1.0"});
  CHECK(linear_ticks(0, 3, 8, true).values == std::vector<double>{0, 1, 2, 3});
  CHECK(linear_ticks(1e-6, 2.1e-6, 3).labels == std::vector<std::string>{"1.0e-6", "1.5e-6", "2.0e-6"});
  CHECK(logarithmic_ticks(1e-3, 1e3, 4).labels ==
        std::vector<std::string>{"1e-3", "0.01", "0.1", "1", "10", "100", "1000"});
  CHECK(logarithmic_ticks(1, 20, 8).labels == std::vector<std::string>{"1", "2", "5", "10", "20"});
}

TEST_CASE("numbers are printed with powers of ten", "[charts]") {
  CHECK(printed_number("0.5") == "0.5");
  CHECK(printed_number("-2") == "−2");
  CHECK(printed_number("1e-12") == "10⁻¹²");
  CHECK(printed_number("2.5e-5") == "2.5·10⁻⁵");
  CHECK(printed_number("-1e+05") == "−10⁵");
}
