#include "packing_support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include <catch2/catch.hpp>

#include <scree/packing/radius_distribution.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;

namespace {

constexpr std::size_t radius_count = 100'000;

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

double standard_error(double variance) { return std::sqrt(variance / double(radius_count)); }

double density(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi); }
double share_below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

std::string refusal_of_radii(const RadiusDistribution& distribution) {
  return error_of([&] { check(distribution); });
}

}  // namespace

TEST_CASE("constant radii are all the same", "[packing]") {
  Random random(1);
  CHECK(draw_radii(ConstantRadius{0.3}, 3, random) == std::vector<double>{0.3, 0.3, 0.3});
}

TEST_CASE("uniform radii have the given range and mean", "[packing]") {
  Random random(1);
  const auto radii = draw_radii(UniformRadius{1.0, 3.0}, radius_count, random);
  CHECK(*std::min_element(radii.begin(), radii.end()) >= 1.0);
  CHECK(*std::max_element(radii.begin(), radii.end()) <= 3.0);
  CHECK(std::abs(mean_of(radii) - 2.0) < 5.0 * standard_error(4.0 / 12.0));
}

TEST_CASE("normal radii beyond the range are drawn again, not clipped", "[packing]") {
  const NormalRadius d{1.0, 0.5, 0.75, 3.0};
  const double a = (d.minimum - d.mean) / d.standard_deviation;
  const double b = (d.maximum - d.mean) / d.standard_deviation;
  const double inside = share_below(b) - share_below(a);
  const double shift = (density(a) - density(b)) / inside;
  const double redrawn = d.mean + d.standard_deviation * shift;
  const double variance = d.standard_deviation * d.standard_deviation *
                          (1.0 + (a * density(a) - b * density(b)) / inside - shift * shift);
  const double clipped = d.minimum * share_below(a) + d.maximum * (1.0 - share_below(b)) + inside * redrawn;
  Random random(1);
  const auto radii = draw_radii(d, radius_count, random);
  const double bound = 5.0 * standard_error(variance);
  REQUIRE(std::abs(redrawn - clipped) > 2.0 * bound);  // the sample distinguishes the two
  CHECK(std::abs(mean_of(radii) - redrawn) < bound);
  CHECK(*std::min_element(radii.begin(), radii.end()) >= d.minimum);
  CHECK(std::count(radii.begin(), radii.end(), d.minimum) == 0);
}

TEST_CASE("bidisperse radii have the number fraction of large ones", "[packing]") {
  Random random(1);
  const auto radii = draw_radii(BidisperseRadius{1.0, 2.0, 0.2}, radius_count, random);
  const auto large = std::count(radii.begin(), radii.end(), 2.0);
  CHECK(large + std::count(radii.begin(), radii.end(), 1.0) == std::ptrdiff_t(radius_count));
  CHECK(std::abs(double(large) / double(radius_count) - 0.2) < 5.0 * standard_error(0.2 * 0.8));
  CHECK(draw_radii(BidisperseRadius{1.0, 2.0, 0.0}, 2, random) == std::vector<double>{1.0, 1.0});
  CHECK(draw_radii(BidisperseRadius{1.0, 2.0, 1.0}, 2, random) == std::vector<double>{2.0, 2.0});
}

TEST_CASE("listed radii are used in order or drawn by weight", "[packing]") {
  Random random(1);
  CHECK(draw_radii(ListedRadius{{3.0, 1.0, 2.0}, {}}, 3, random) == std::vector<double>{3.0, 1.0, 2.0});
  CHECK_THAT(error_of([&] {
               draw_radii(ListedRadius{{3.0, 1.0}, {}}, 3, random);
             }),
             Contains("2 radii for 3 bodies"));
  const auto radii = draw_radii(ListedRadius{{1.0, 2.0, 3.0}, {1.0, 0.0, 3.0}}, radius_count, random);
  CHECK(std::count(radii.begin(), radii.end(), 2.0) == 0);
  const double fraction = double(std::count(radii.begin(), radii.end(), 3.0)) / double(radius_count);
  CHECK(std::abs(fraction - 0.75) < 5.0 * standard_error(0.75 * 0.25));
}

TEST_CASE("the same seed draws the same radii, another seed others", "[packing]") {
  const RadiusDistribution d = NormalRadius{1.0, 0.1, 0.5, 1.5};
  Random first(9);
  Random second(9);
  Random third(10);
  const auto radii = draw_radii(d, 20, first);
  CHECK(radii == draw_radii(d, 20, second));
  CHECK(radii != draw_radii(d, 20, third));
}

TEST_CASE("the range of a distribution is that of the possible radii", "[packing]") {
  CHECK(smallest_radius(BidisperseRadius{1.0, 2.0, 0.5}) == 1.0);
  CHECK(largest_radius(BidisperseRadius{1.0, 2.0, 0.0}) == 1.0);
  CHECK(largest_radius(ListedRadius{{1.0, 3.0, 2.0}, {}}) == 3.0);
  CHECK(smallest_radius(NormalRadius{1.0, 0.1, 0.9, 1.2}) == 0.9);
}

TEST_CASE("invalid distributions are refused with a cure", "[packing]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_THAT(refusal_of_radii(ConstantRadius{0.0}),
             Contains("radius 0 m is not positive") && Contains("; give"));
  CHECK_THAT(refusal_of_radii(ConstantRadius{nan}), Contains("not positive and finite"));
  CHECK_THAT(refusal_of_radii(UniformRadius{2.0, 1.0}),
             Contains("minimum 2 m exceeds maximum 1 m; swap them"));
  CHECK_THAT(refusal_of_radii(UniformRadius{1.0, infinity}), Contains("maximum inf m"));
  CHECK_THAT(refusal_of_radii(NormalRadius{1.0, 0.0, 0.5, 1.5}), Contains("standard deviation 0 m"));
  CHECK_THAT(refusal_of_radii(NormalRadius{1.0, 0.1, 0.0, 1.5}), Contains("minimum 0 m"));
  CHECK_THAT(refusal_of_radii(NormalRadius{nan, 0.1, 0.5, 1.5}), Contains("mean is not finite"));
  CHECK_THAT(refusal_of_radii(BidisperseRadius{1.0, 2.0, 1.5}), Contains("fraction 1.5"));
  CHECK_THAT(refusal_of_radii(BidisperseRadius{2.0, 1.0, 0.5}), Contains("swap them"));
  CHECK_THAT(refusal_of_radii(ListedRadius{{}, {}}), Contains("list is empty"));
  CHECK_THAT(refusal_of_radii(ListedRadius{{1.0}, {1.0, 2.0}}), Contains("2 weights for 1 radius"));
  CHECK_THAT(refusal_of_radii(ListedRadius{{1.0}, {-1.0}}), Contains("weight -1"));
  CHECK_THAT(refusal_of_radii(ListedRadius{{1.0}, {0.0}}), Contains("add up to 0"));
}

TEST_CASE("a range with almost no deviates is refused in either tail", "[packing]") {
  // The fraction beyond 4 standard deviations is 3.2e-5, beyond 3 it is 1.35e-3.
  CHECK_THAT(refusal_of_radii(NormalRadius{1.0, 0.1, 1.4, 2.0}),
             Contains("3.2e-05") && Contains("widen the range"));
  CHECK_THAT(refusal_of_radii(NormalRadius{1.0, 0.1, 0.1, 0.6}), Contains("3.2e-05"));
  CHECK_THAT(refusal_of_radii(NormalRadius{1.0, 0.01, 5.0, 6.0}), Contains("widen the range"));
  CHECK(refusal_of_radii(NormalRadius{1.0, 0.1, 1.3, 2.0}).empty());
}
