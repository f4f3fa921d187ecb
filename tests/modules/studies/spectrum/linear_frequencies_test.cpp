#include "linear_frequencies.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <catch2/catch.hpp>

using namespace scree::spectrum;

TEST_CASE("frequencies are solved in batches that fit into memory", "[spectrum]") {
  std::vector<double> all(100000);
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = double(k);
  CHECK(first_batch(all, 8) == all);
  const std::vector<double> some = first_batch(all, 4032);
  CHECK(some.size() == 5166);  // 2e9/(96 · 4032)
  CHECK(std::equal(some.begin(), some.end(), all.begin()));
  CHECK(first_batch(all, 100000000).size() == 48);
  CHECK(first_batch({}, 8).empty());
}

TEST_CASE("a maximum that is too narrow for the grid gets eight frequencies in its width, a wide one none",
          "[spectrum]") {
  // |1/(f² − f0² + i f b)| is b wide where its square has half of the maximum.
  const double f0 = 100;
  const auto further = [&](double b) {
    SpectrumPlan plan;
    plan.observed.resize(1);
    MethodSpectrum spectrum;
    spectrum.columns.resize(1);
    for (double f = 90; f <= 110; ++f) {
      spectrum.frequencies.push_back(f);
      spectrum.columns[0].response.push_back(1.0 / std::complex<double>(f * f - f0 * f0, f * b));
    }
    return frequencies_about_maxima(plan, spectrum);
  };
  CHECK(further(8).empty());
  const std::vector<double> found = further(1);
  CHECK(std::is_sorted(found.begin(), found.end()));
  // Three widths on each side, and what is left of the intervals there.
  CHECK(found.front() >= f0 - 4);
  CHECK(found.back() <= f0 + 4);
  const auto in_width =
      std::count_if(found.begin(), found.end(), [&](double f) { return std::abs(f - f0) < 0.5; });
  // With the maximum itself, which is on the grid; the width is read from the grid to a quarter.
  CHECK(in_width + 1 >= 6);
  CHECK(in_width + 1 <= 11);
  for (const double f : found) CHECK(f != std::round(f));
}

TEST_CASE("frequencies that are missing are those that were not found yet", "[spectrum]") {
  CHECK(missing({1, 2, 3, 4}, {2, 4}) == std::vector<double>{1, 3});
  CHECK(missing({1, 2}, {}) == std::vector<double>{1, 2});
  CHECK(missing({1, 2}, {1, 2}).empty());
}
