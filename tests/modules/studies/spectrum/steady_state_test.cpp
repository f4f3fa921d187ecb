#include "steady_state.hpp"

#include <cmath>
#include <complex>

#include <catch2/catch.hpp>

using namespace scree::spectrum;
using Complex = std::complex<double>;

namespace {

// Adds blocks of a response with the transient of one mode until it is steady; returns their number.
int blocks_until_steady(SteadyState& steady, Complex limit, Complex transient, Complex ratio, int most) {
  for (int k = 0; k < most; ++k) {
    steady.add({{limit + transient * std::pow(ratio, k), 0, 0}});
    if (steady.is_reached()) return k + 1;
  }
  return 0;
}

}  // namespace

TEST_CASE("the transient of one mode is told from the steady response by four blocks", "[spectrum]") {
  const Complex limit(3, -4), ratio = std::polar(0.97, 0.4);
  SteadyState steady(1e-3, {0});
  CHECK(blocks_until_steady(steady, limit, Complex(2, 1), ratio, 10) == 4);
  // Round-off over the square of 1 - ratio, 0.16.
  CHECK(std::abs(steady.limits()[0].response - limit) < 1e-13);
  CHECK(steady.limits()[0].error < 1e-13);
}

TEST_CASE("a response that grows is not steady", "[spectrum]") {
  SteadyState steady(1e-3, {0});
  CHECK(blocks_until_steady(steady, 1, 1, 1.5, 20) == 0);
}

TEST_CASE("what is small beside the scale need not be steady", "[spectrum]") {
  SteadyState steady(1e-3, {1e6});
  CHECK(blocks_until_steady(steady, 1, 1, 1.5, 6) == 4);
}
