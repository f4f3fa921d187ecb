#include "unit_text.hpp"

#include <catch2/catch.hpp>

using scree::state_file::h5md_unit;
using scree::state_file::state_unit;

TEST_CASE("units are written as in H5MD and read back", "[unit_text]") {
  for (const auto& [unit, h5md] : {std::pair{"m", "m"},
                                   {"1", "1"},
                                   {"m/s", "m s-1"},
                                   {"1/s", "s-1"},
                                   {"N m", "N m"},
                                   {"kg m^2", "kg m+2"},
                                   {"m^2/s^2", "m+2 s-2"},
                                   {"kg m^2/s", "kg m+2 s-1"},
                                   {"rad/s", "rad s-1"},
                                   {"W/m^2 K", "W m-2 K-1"},
                                   {"m or rad", "m or rad"}}) {
    CHECK(h5md_unit(unit) == h5md);
    CHECK(state_unit(h5md) == unit);
  }
}

TEST_CASE("a unit that no state has is read as some text", "[unit_text]") {
  for (const char* odd : {"+", "-", "-1", " ", "  ", "m--1", "m-1 ", "^", "/", "s-"}) {
    CAPTURE(odd);
    CHECK_NOTHROW(state_unit(odd));
  }
}
