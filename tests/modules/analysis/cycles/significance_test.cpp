#include "significance.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

using namespace scree::cycles;

TEST_CASE("tails of t and F agree with their closed forms", "[significance]") {
  for (const double t : {-3.0, -0.2, 0.0, 0.5, 2.0, 40.0}) {
    CHECK(tail_of_t(t, 1) == Approx(0.5 - std::atan(t) / std::numbers::pi).epsilon(1e-12));
    CHECK(tail_of_t(t, 2) == Approx(0.5 - 0.5 * t / std::sqrt(2 + t * t)).epsilon(1e-11));
  }
  for (const double f : {0.1, 1.0, 8.0, 300.0}) {
    CHECK(tail_of_f(f, 2, 40) == Approx(std::pow(1 + f / 20, -20)).epsilon(1e-12));
    CHECK(tail_of_f(f, 6, 2) == Approx(1 - std::pow(6 * f / (6 * f + 2), 3)).epsilon(1e-10));
  }
}

TEST_CASE("equal values share their mean rank", "[significance]") {
  CHECK(ranks_of(std::vector<double>{5, 1, 5, 5, -2}) == std::vector<double>{4, 2, 4, 4, 1});
}
