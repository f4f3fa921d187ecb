#include <cmath>

#include <catch2/catch.hpp>

#include <scree/packing/random.hpp>

using scree::Vec3;
using scree::packing::Random;

TEST_CASE("generator gives the published outputs of xoshiro256++", "[packing]") {
  Random random(std::array<std::uint64_t, 4>{1, 2, 3, 4});
  for (const std::uint64_t expected : {41943041u, 58720359u}) CHECK(random.bits() == expected);
  CHECK(random.bits() == 3588806011781223u);
  CHECK(random.bits() == 3591011842654386u);
  CHECK(random.bits() == 9228616714210784205u);
}

TEST_CASE("seed 0 expands to the published outputs of splitmix64", "[packing]") {
  const Random random(0);
  CHECK(random.state()[0] == 0xe220a8397b1dcdafu);
  CHECK(random.state()[1] == 0x6e789e6aa1b965f4u);
}

// Evaluated from the definitions of generator and polar method, independently of this library.
TEST_CASE("a seed gives the same bits everywhere", "[packing]") {
  Random uniform(42);
  CHECK(uniform.uniform() == 0x1.a0ec9a9e88ecdp-1);
  CHECK(uniform.uniform() == 0x1.467905d15dbccp-2);
  CHECK(uniform.uniform() == 0x1.f7c0f9f61849dp-1);
  Random normal(42);
  CHECK(normal.normal() == 0x1.f679d98b6ab7bp-1);
  CHECK(normal.normal() == 0x1.571f94d19c30ap+0);
  CHECK(normal.normal() == -0x1.edae4f6954ef1p-1);
  CHECK(normal.normal() == 0x1.91df36fc7a31dp-3);
}

TEST_CASE("a saved state continues the sequence", "[packing]") {
  Random original(5);
  original.normal();
  Random copy(original.state());
  for (int k = 0; k < 10; ++k) CHECK(copy.normal() == original.normal());
}

TEST_CASE("deviates have the moments of their distribution within 5 standard errors", "[packing]") {
  constexpr int count = 200'000;
  Random random(1);
  double uniform_sum = 0.0;
  double square = 0.0;
  double fourth = 0.0;
  double normal_sum = 0.0;
  for (int k = 0; k < count; ++k) {
    const double u = random.uniform(2.0, 5.0);
    REQUIRE((u >= 2.0 && u <= 5.0));
    uniform_sum += u;
    const double n = random.normal();
    normal_sum += n;
    square += n * n;
    fourth += n * n * n * n;
  }
  const double root = std::sqrt(count);
  CHECK(std::abs(uniform_sum / count - 3.5) < 5.0 * 3.0 / std::sqrt(12.0) / root);
  CHECK(std::abs(normal_sum / count) < 5.0 / root);
  CHECK(std::abs(square / count - 1.0) < 5.0 * std::sqrt(2.0) / root);   // variance of n²: 3 - 1
  CHECK(std::abs(fourth / count - 3.0) < 5.0 * std::sqrt(96.0) / root);  // variance of n⁴: 105 - 9
}

TEST_CASE("points in a ball fill it evenly", "[packing]") {
  constexpr int count = 100'000;
  const int dimension = GENERATE(2, 3);
  Random random(3);
  double square = 0.0;
  for (int k = 0; k < count; ++k) {
    const Vec3 point = random.in_ball(2.0, dimension);
    const double fraction = dot(point, point) / 4.0;
    REQUIRE(fraction <= 1.0);
    if (dimension == 2) REQUIRE(point[2] == 0.0);
    square += fraction;
  }
  const double d = dimension;
  const double mean = d / (d + 2.0);
  const double variance = d / (d + 4.0) - mean * mean;
  CHECK(std::abs(square / count - mean) < 5.0 * std::sqrt(variance / count));
}
