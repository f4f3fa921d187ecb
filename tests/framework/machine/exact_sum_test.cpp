#include "machine/exact_sum.hpp"

#include "contacts/contact_sums.hpp"
#include "numbers.hpp"
#include "ranks/rank_sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

using scree::ExactSum;
using scree::test::infinite;

namespace {

double sum_of(const std::vector<double>& terms) {
  ExactSum sum;
  for (const double term : terms) sum.add(term);
  return sum.value();
}

scree::ContactSums total_of(const std::vector<scree::ContactSums>& tiles) {
  scree::ContactSums total;
  scree::RankSums sums(nullptr);
  add_total(tiles, total, sums);
  return total;
}

constexpr double scree::ContactSums::*members[] = {&scree::ContactSums::elastic_normal,
                                                   &scree::ContactSums::elastic_tangential,
                                                   &scree::ContactSums::dissipation_rate_normal,
                                                   &scree::ContactSums::dissipation_rate_tangential,
                                                   &scree::ContactSums::dissipation_rate_rolling,
                                                   &scree::ContactSums::dissipated_friction,
                                                   &scree::ContactSums::dissipated_release,
                                                   &scree::ContactSums::created_power,
                                                   &scree::ContactSums::created,
                                                   &scree::ContactSums::max_overlap_ratio};

}  // namespace

// Terms are multiples of 2^-60 below 2^50, whose sums fit into an integer of 128 bits; the compiler rounds
// it.
TEST_CASE("an exact sum equals the sum of integers, rounded once", "[exact_sum]") {
  __extension__ typedef __int128 Wide;
  std::mt19937_64 generator(1);
  for (int trial = 0; trial < 2000; ++trial) {
    Wide expected = 0;
    std::vector<double> terms;
    const int count = 1 + int(generator() % 40);
    for (int k = 0; k < count; ++k) {
      const auto mantissa = std::int64_t(generator() >> 11) * (generator() % 2 ? 1 : -1);
      const int shift = int(generator() % 58);
      terms.push_back(std::ldexp(double(mantissa), shift - 60));
      expected += Wide(mantissa) * (Wide(1) << shift);
    }
    REQUIRE(sum_of(terms) == std::ldexp(double(expected), -60));
    std::shuffle(terms.begin(), terms.end(), generator);
    REQUIRE(sum_of(terms) == std::ldexp(double(expected), -60));
    ExactSum halves[2];
    for (std::size_t k = 0; k < terms.size(); ++k) halves[k % 2].add(terms[k]);
    halves[0].add(halves[1]);
    REQUIRE(halves[0].value() == std::ldexp(double(expected), -60));
  }
}

TEST_CASE("exact sums reach from the smallest to the largest double", "[exact_sum]") {
  const double smallest = std::numeric_limits<double>::denorm_min(),
               largest = std::numeric_limits<double>::max();
  CHECK(sum_of({}) == 0);
  CHECK(sum_of({largest, smallest, -largest}) == smallest);
  CHECK(sum_of({1e308, 1, -1e308}) == 1);
  CHECK(sum_of({smallest, smallest, smallest}) == 3 * smallest);
  CHECK(sum_of({largest, -smallest}) == largest);
  CHECK(sum_of({largest, largest}) == infinite);
  CHECK(sum_of({largest, largest, -largest}) == largest);
  CHECK(sum_of({-largest, -largest}) == -infinite);
}

TEST_CASE("exact sums round ties to even, and what decides a tie may be far below", "[exact_sum]") {
  const double unit = std::ldexp(1.0, -52);
  CHECK(sum_of({1, 0.5 * unit}) == 1);
  CHECK(sum_of({1 + unit, 0.5 * unit}) == 1 + 2 * unit);
  CHECK(sum_of({1, 0.5 * unit, 1e-300}) == 1 + unit);
  CHECK(sum_of({1, 0.5 * unit, -1e-300}) == 1);
  CHECK(sum_of({-1, -0.5 * unit, -1e-300}) == -1 - unit);
}

TEST_CASE("infinities and numbers that are not one pass through exact sums in any order", "[exact_sum]") {
  CHECK(sum_of({1, infinite, -5}) == infinite);
  CHECK(sum_of({-infinite, 1e300}) == -infinite);
  CHECK(std::isnan(sum_of({infinite, 1, -infinite})));
  CHECK(std::isnan(sum_of({1, std::nan(""), 2})));
}

TEST_CASE("integers of several exact sums add up to those of their sum", "[exact_sum]") {
  std::mt19937_64 generator(9);
  std::uniform_int_distribution<int> exponent(-1080, 1020), count(0, 40);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<std::int64_t> words(ExactSum::word_count, 0), of_share(ExactSum::word_count);
    std::vector<double> terms;
    const int centre = exponent(generator), width = trial % 3 == 0 ? 1000 : 20;
    for (int share = 0; share < 5; ++share) {
      ExactSum sum;
      for (int k = count(generator); k > 0; --k) {
        const int about = std::clamp(centre + exponent(generator) % width, -1080, 1010);
        terms.push_back(std::ldexp(mantissa(generator), about));
        if (trial % 4 == 1 && k % 2) terms.back() = terms.size() > 1 ? -terms[terms.size() - 2] : 0;
        sum.add(terms.back());
      }
      sum.write(ExactSum::Words(of_share));
      for (std::size_t k = 0; k < words.size(); ++k) words[k] += of_share[k];
    }
    REQUIRE(ExactSum::value_of(std::span<const std::int64_t, ExactSum::word_count>(words)) == sum_of(terms));
  }
}

TEST_CASE("integers of exact sums keep infinities and numbers that are not one", "[exact_sum]") {
  const auto together = [](double one, double other) {
    std::vector<std::int64_t> words(ExactSum::word_count), more(ExactSum::word_count);
    ExactSum first, second;
    first.add(one), second.add(other);
    first.write(ExactSum::Words(words)), second.write(ExactSum::Words(more));
    for (std::size_t k = 0; k < words.size(); ++k) words[k] += more[k];
    return ExactSum::value_of(std::span<const std::int64_t, ExactSum::word_count>(words));
  };
  CHECK(together(infinite, -5) == infinite);
  CHECK(together(1e300, -infinite) == -infinite);
  CHECK(std::isnan(together(infinite, -infinite)));
  CHECK(std::isnan(together(std::nan(""), 1)));
}

TEST_CASE("sums of contacts over tiles are the same in any order of the tiles", "[exact_sum]") {
  std::mt19937_64 generator(5);
  std::normal_distribution<double> normal;
  std::vector<scree::ContactSums> tiles(20);
  for (scree::ContactSums& tile : tiles)
    for (double scree::ContactSums::*const member : members) tile.*member = std::exp(10 * normal(generator));
  const scree::ContactSums expected = total_of(tiles);
  for (int trial = 0; trial < 20; ++trial) {
    std::shuffle(tiles.begin(), tiles.end(), generator);
    const scree::ContactSums total = total_of(tiles);
    for (double scree::ContactSums::*const member : members) {
      REQUIRE(total.*member == expected.*member);
      REQUIRE(total.*member > 0);
    }
  }
}

TEST_CASE("a million terms of both signs are summed without a carry that is lost", "[exact_sum]") {
  ExactSum sum;
  for (int k = 0; k < 1000000; ++k) sum.add(k % 2 ? -0x1.fffffffffffffp+31 : 0x1.fffffffffffffp+32);
  CHECK(sum.value() == 500000 * 0x1.fffffffffffffp+31);
}
