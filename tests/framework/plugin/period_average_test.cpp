#include "signals.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/plugin/lock_in.hpp>
#include <scree/plugin/period_average.hpp>

using namespace scree;
using scree::test::equal_times;
using scree::test::sine;
using scree::test::turned_by;

namespace {

// Relative error of the amplitude and error of the phase (rad) of a sine of 1 Hz, whichever is larger.
double error_of_line(const std::vector<double>& times, const std::function<double(double)>& drift) {
  LockInOptions options;
  options.frequency = 1, options.drift_degree = 0, options.harmonics = 1;
  options.duration = times.back() - times.front();
  std::vector<double> state(LockIn::state_size(options)), ring(PeriodAverage::state_size(times.size()));
  LockIn fit(options, state);
  PeriodAverage average(1, ring);
  for (const double t : times)
    average.add(t, drift(t) + sine(0.5, 1, 0.4, t), [&](double time, double value) { fit.add(time, value); });
  const SpectralLine line = fit.result().lines[0];
  return std::max(std::abs(line.amplitude / 0.5 - 1), std::abs(turned_by(line.phase, 0.4)));
}

double none(double) { return 0; }

}  // namespace

TEST_CASE("the mean over a period keeps amplitude and phase for whole numbers of samples",
          "[period_average]") {
  // Round-off of some hundred samples.
  for (const int samples : {3, 4, 7, 20, 101})
    CHECK(error_of_line(equal_times(std::size_t(30 * samples), 1.0 / samples), none) < 1e-12);
}

TEST_CASE("between whole numbers of samples its error is below the stated bound", "[period_average]") {
  double largest = 0;
  for (const double samples : {4.5, 5.3, 10.5, 20.37, 50.5}) {
    const double step = 1 / samples;
    const double error = error_of_line(equal_times(std::size_t(40 * samples), step), none);
    CHECK(error < step * step * step);
    largest = std::max(largest, error / (step * step * step));
  }
  CHECK(largest > 0.1);  // the bound is not idle
}

TEST_CASE("at unequal steps its error is below the stated bound", "[period_average]") {
  const auto times = scree::test::random_times(2000, 0.02, 8);  // up to 0.036 s
  CHECK(error_of_line(times, none) < std::pow(2 * std::numbers::pi * 0.036, 2) / 12);
}

TEST_CASE("a linear drift is removed and a curved one leaves what is stated", "[period_average]") {
  const auto times = equal_times(2000, 0.01);
  CHECK(error_of_line(times, [](double t) { return 100 * t; }) < 1e-11);
  std::vector<double> ring(PeriodAverage::state_size(101));
  PeriodAverage average(1, ring);
  // The straight lines between samples add h^2/6 of the curvature's c: 1e-4/6.
  for (const double t : times)
    average.add(t, 3 * t * t, [](double, double rest) { CHECK(std::abs(rest + 0.25) < 3 * 1e-4); });
}

TEST_CASE("half a period is lost at each end, and the numbers kept are the whole state", "[period_average]") {
  const auto times = equal_times(1001, 0.01);
  std::vector<double> ring(PeriodAverage::state_size(101));
  std::vector<double> emitted;
  for (const double t : times)
    PeriodAverage(1, ring).add(t, sine(1, 1, 0, t), [&](double at, double) { emitted.push_back(at); });
  REQUIRE(emitted.size() == 901);
  CHECK(emitted.front() == Approx(0.5));
  CHECK(emitted.back() == Approx(9.5));
}

TEST_CASE("more samples in a period than fit are refused", "[period_average]") {
  std::vector<double> ring(PeriodAverage::state_size(10));
  PeriodAverage average(1, ring);
  const auto fill = [&] {
    for (int k = 0; k < 200; ++k) average.add(0.01 * k, 0, [](double, double) {});
  };
  CHECK_THROWS_WITH(fill(), "period average: more than 10 samples in a period of 1 s; give room for more");
  CHECK_THROWS_AS(PeriodAverage(0, ring), scree::Error);
}

TEST_CASE("a long record on a steep drift loses no digits, and clusters of samples need no more room",
          "[period_average]") {
  std::vector<double> ring(PeriodAverage::state_size(11));
  PeriodAverage average(1, ring);
  double largest = 0;
  // Values up to 1e7: round-off of some 1e-9 each; their integral since the start would have 1e-5.
  for (const double t : equal_times(100000, 0.1))
    average.add(t, 1000 * t, [&](double, double rest) { largest = std::max(largest, std::abs(rest)); });
  CHECK(largest < 3e-8);
  std::vector<double> few(PeriodAverage::state_size(6));
  PeriodAverage clusters(1, few);
  int emitted = 0;
  for (int k = 0; k < 100; ++k)  // 5 samples within 0.4, then none for 0.7
    clusters.add(k / 5 * 1.1 + k % 5 * 0.1, 1,
                 [&](double, double rest) { emitted += std::abs(rest) < 1e-12; });
  CHECK(emitted == 90);  // not those of the first and last cluster
}
