#include "outliers.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

using scree::cycles::find_outliers;

namespace {

constexpr std::size_t outlier_samples = 72;
constexpr double outlier_factor = 10, outlier_round_off = 1e-13;

std::vector<double> noise(std::mt19937_64& random) {
  std::normal_distribution<double> normal(0, 1e-12);
  std::vector<double> values(outlier_samples);
  std::generate(values.begin(), values.end(), [&] { return normal(random); });
  return values;
}

template <class Curve>
std::vector<std::size_t> outliers_of(const Curve& curve) {
  std::vector<double> values;
  for (std::size_t n = 0; n < outlier_samples; ++n) values.push_back(curve(double(n)));
  return find_outliers(values, outlier_factor, outlier_round_off).places;
}

}  // namespace

TEST_CASE("the first value and the last can stand off", "[outliers]") {
  std::mt19937_64 random(1);
  for (const std::size_t place : {std::size_t(0), outlier_samples - 1})
    for (int series = 0; series < 200; ++series) {
      std::vector<double> values = noise(random);
      values[place] += 1e-7;
      CHECK(find_outliers(values, outlier_factor, outlier_round_off).places ==
            std::vector<std::size_t>{place});
    }
  // The first value of a series that settles does not stand off.
  const std::vector<std::size_t> none;
  CHECK(outliers_of([](double n) { return std::exp(-n); }) == none);
  CHECK(outliers_of([](double n) { return 1 / (n + 1); }) == none);
  CHECK(outliers_of([](double n) { return 3e-9 * n; }) == none);
}

TEST_CASE("up to an eighth of the values stand off", "[outliers]") {
  // Exactly the eight equal outliers must be found in nine of ten series, less three standard deviations of
  // such a number of 200.
  std::mt19937_64 random(1);
  int found = 0;
  for (int series = 0; series < 200; ++series) {
    std::vector<std::size_t> places(outlier_samples - 2);
    std::iota(places.begin(), places.end(), std::size_t(1));
    std::shuffle(places.begin(), places.end(), random);
    places.resize(8);
    std::sort(places.begin(), places.end());
    std::vector<double> values = noise(random);
    for (const std::size_t place : places) values[place] += 1e-7;
    found += find_outliers(values, outlier_factor, outlier_round_off).places == places;
  }
  CHECK(found >= 180 - 13);
}

TEST_CASE("the top of a smooth curve does not stand off", "[outliers]") {
  const std::vector<std::size_t> none;
  CHECK(outliers_of([](double n) { return std::exp(-(n - 30) * (n - 30) / 50); }) == none);
  CHECK(outliers_of([](double n) { return std::exp(-n / 10) * std::sin(n / 3); }) == none);
}
