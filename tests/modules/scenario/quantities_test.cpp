#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include <scree/scenario/quantities.hpp>

using scree::scenario::series_statistic;

TEST_CASE("statistics of a series", "[scenario]") {
  const std::vector<double> values = {3, 1, 8, 4};
  CHECK(series_statistic(values, "first") == 3);
  CHECK(series_statistic(values, "last") == 4);
  CHECK(series_statistic(values, "min") == 1);
  CHECK(series_statistic(values, "max") == 8);
  CHECK(series_statistic(values, "mean") == 4);
  CHECK(std::isnan(series_statistic({}, "mean")));
}

TEST_CASE("a series that is not a number somewhere has no smallest, largest or mean value", "[scenario]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::vector<double>& values : {std::vector<double>{nan, 1, 2}, {1, nan, 2}, {1, 2, nan}})
    for (const char* statistic : {"min", "max", "mean"})
      CHECK(std::isnan(series_statistic(values, statistic)));
  // As of a stage that is over.
  CHECK(series_statistic({1, 2, nan}, "last_number") == 2);
  CHECK(std::isnan(series_statistic({nan}, "last_number")));
}
