#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/cycles/cycle_series.hpp>
#include <scree/error.hpp>

using scree::cycles::cycle_series;
using scree::cycles::CycleSeries;
using scree::cycles::CycleTimes;

namespace {

struct Record {
  std::vector<double> times, strain, load;
};

// A load 3 + 0.5 (1 − cos) and a strain of amplitude 2e-3 that lags by a quarter of a cycle, so that the loop
// is an ellipse, on a drift.
Record ellipses(double cycles, int per_cycle, double drift = 0, double phase = std::numbers::pi / 2) {
  Record r;
  for (int k = 0; k <= int(cycles * per_cycle); ++k) {
    const double t = 4.0 * k / per_cycle, turn = 2 * std::numbers::pi * t / 4;
    r.times.push_back(10 + t);
    r.strain.push_back(0.7 + 2e-3 * (1 - std::cos(turn - phase)) + drift * t / 4);
    r.load.push_back(3 + 0.5 * (1 - std::cos(turn)));
  }
  return r;
}

CycleSeries series_of(const Record& r, const CycleTimes& cycles) {
  return cycle_series(r.times, r.strain, r.load, cycles);
}

std::string refusal_of_record(const Record& r, const CycleTimes& cycles) {
  try {
    series_of(r, cycles);
  } catch (const scree::Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the area of an elliptic loop is pi a b times that of its polygon", "[cycle_series]") {
  for (const int n : {3, 8, 200}) {
    const CycleSeries s = series_of(ellipses(5, n), {4, 10});
    REQUIRE(s.loops.size() == 5);
    const double polygon = std::sin(2 * std::numbers::pi / n) / (2 * std::numbers::pi / n);
    // A few times the round-off of strains of 0.7 over loops of 2e-3, 1e-13.
    for (const auto& loop : s.loops)
      CHECK(loop.area == Approx(std::numbers::pi * 0.5 * 2e-3 * polygon).epsilon(1e-12));
  }
  // In the opposite sense the load takes energy back.
  const CycleSeries back = series_of(ellipses(5, 200, 0, -std::numbers::pi / 2), {4, 10});
  CHECK(back.loops[2].area < 0);
}

TEST_CASE("stiffness is the slope between the extremes of the load", "[cycle_series]") {
  const CycleSeries s = series_of(ellipses(5, 8, 1e-5, 0), {4, 10});
  // In phase: 1 over 4e-3 and the drift of half a cycle.
  for (const auto& loop : s.loops) CHECK(loop.stiffness == Approx(1 / (4e-3 + 0.5e-5)).epsilon(1e-11));
}

TEST_CASE("strain is taken at the minima of the load, between samples on a straight line", "[cycle_series]") {
  const CycleSeries s = series_of(ellipses(5, 8, 1e-5), {4, 10});
  REQUIRE(s.strain.size() == 6);
  for (std::size_t n = 0; n < 6; ++n) CHECK(s.strain[n] == Approx(0.702 + 1e-5 * double(n)).epsilon(1e-14));
  CHECK(s.load == std::vector<double>(6, 3.0));
  std::vector<double> times, strain;
  for (int k = 0; k < 50; ++k) {
    times.push_back(0.3 * k);
    strain.push_back(5 - 2 * times.back());
  }
  const CycleSeries line = cycle_series(times, strain, {}, {1, 0.5});
  REQUIRE(line.strain.size() == 15);
  CHECK(line.loops.empty());
  for (std::size_t n = 0; n < 15; ++n) CHECK(line.strain[n] == Approx(4 - 2 * double(n)).margin(1e-13));
}

TEST_CASE("with one sample per cycle strains are the samples, and loops have no numbers", "[cycle_series]") {
  const std::vector<double> times = {9.200000000000001, 19.2, 29.2, 39.20000000000001}, strain = {1, 3, 2, 7},
                            load = {1, 2, 1, 2};
  const CycleSeries s = cycle_series(times, strain, load, {10, times[0]});
  CHECK(s.strain == strain);
  REQUIRE(s.loops.size() == 3);
  CHECK(std::isnan(s.loops[0].area));
  CHECK(std::isnan(s.loops[0].stiffness));
}

TEST_CASE("a period that is a multiple of the load's own is seen", "[cycle_series]") {
  for (const int per_cycle : {3, 8, 21, 200}) {
    const Record r = ellipses(12, per_cycle);
    for (const std::size_t multiple : {1, 2, 3, 4, 12}) {
      INFO(per_cycle << " samples in a period, " << multiple << " periods");
      CHECK(series_of(r, {4.0 * double(multiple), 10}).load_periods == multiple);
    }
  }
  // Every second maximum is higher by a fifth: the load has the longer period.
  Record unequal = ellipses(12, 20);
  for (std::size_t k = 0; k < unequal.load.size(); ++k)
    unequal.load[k] -= k / 20 % 2 ? (unequal.load[k] - 3) / 5 : 0;
  CHECK(series_of(unequal, {8, 10}).load_periods == 1);
  CHECK(cycle_series(unequal.times, unequal.strain, {}, {8, 10}).load_periods == 1);
}

TEST_CASE("a load that hardly changes in a part of its period is not taken to repeat there",
          "[cycle_series]") {
  // In a hundredth of a period a sine changes by less than the tolerance of a load that repeats.
  for (const int per_cycle : {100, 400}) CHECK(series_of(ellipses(5, per_cycle), {4, 10}).load_periods == 1);
}

TEST_CASE("a minimum in a gap, and a loop with a gap, are refused", "[cycle_series]") {
  const Record whole = ellipses(12, 8);
  const auto without = [&](std::size_t from, std::size_t to) {
    Record r = whole;
    for (std::vector<double>* column : {&r.times, &r.strain, &r.load})
      column->erase(column->begin() + std::ptrdiff_t(from), column->begin() + std::ptrdiff_t(to));
    return r;
  };
  CHECK(refusal_of_record(without(17, 20), {4, 10}).empty());  // half a period
  CHECK(
      refusal_of_record(without(17, 21), {4, 10}) ==
      "there is no sample from 18 s to 20.5 s, more than half a period; give a series without gaps, or one with samples at the minima of the load");
  CHECK(refusal_of_record(without(17, 60), {4, 10}).starts_with("there is no sample from 18 s to 40 s, "));
  CHECK(refusal_of_record(without(17, 60), {4, 42}).empty());         // before the cycles
  CHECK(refusal_of_record(without(17, 60), {4, 42 + 1e-9}).empty());  // to round-off
  CHECK(refusal_of_record(without(66, 96), {4, 10}).starts_with("there is no sample from 42.5 s to 58 s, "));
  // After the last whole cycle.
  Record behind = whole;
  for (const double t : {2.5, 3.0}) {
    behind.times.push_back(58 + t);
    behind.strain.push_back(whole.strain.back());
    behind.load.push_back(whole.load.back());
  }
  CHECK(refusal_of_record(behind, {4, 10}).empty());
}

TEST_CASE("samples at the minima are enough for strains", "[cycle_series]") {
  std::vector<double> times, strain;
  const auto add = [&](double time) {
    times.push_back(time);
    strain.push_back(1e-3 * std::sin(time));
  };
  for (int n = 0; n < 6; ++n) add(4.0 * n);
  CHECK(cycle_series(times, strain, {}, {4, 0}).strain == strain);
  // The first half of each cycle.
  times.clear(), strain.clear();
  for (int n = 0; n < 6; ++n)
    for (const double t : {0.0, 0.5, 1.0, 1.5}) add(4.0 * n + t);
  CHECK(cycle_series(times, strain, {}, {4, 0}).strain.size() == 6);
  CHECK_THROWS_WITH(cycle_series(times, strain, strain, {4, 0}),
                    Catch::StartsWith("there is no sample from 1.5 s to 4 s, "));
  // A sample each 0.7 periods: only every seventh minimum has one.
  times.clear(), strain.clear();
  for (int k = 0; k < 40; ++k) add(2.8 * k);
  CHECK_THROWS_WITH(cycle_series(times, strain, {}, {4, 0}),
                    Catch::StartsWith("there is no sample from 2.8 s to 5.6 s, "));
}

TEST_CASE("strain of lengths is the difference of their ratios", "[cycle_series]") {
  const std::vector<double> x = {3, 2, 1}, y = {1, 2, 3};
  CHECK(scree::cycles::strain_of_lengths(x, y, 1) == std::vector<double>{-1, 0, 1});
  CHECK_THROWS_AS(scree::cycles::strain_of_lengths(x, y, 3), scree::Error);
  CHECK_THROWS_AS(scree::cycles::strain_of_lengths(std::vector<double>{1, 0}, std::vector<double>{1, 1}, 0),
                  scree::Error);
}

TEST_CASE("series without cycles are refused in one line", "[cycle_series]") {
  const Record good = ellipses(5, 8);
  CHECK(refusal_of_record(good, {4, 10}).empty());
  CHECK(
      refusal_of_record(good, {0.4, 10}) ==
      "a period of 0.4 s is shorter than the 0.5 s between samples; give the period of the load, or sample more often");
  CHECK(refusal_of_record(good, {40, 10})
            .starts_with("no cycle of 40 s from 10 s to 30 s, where the samples end; "));
  CHECK(refusal_of_record(good, {4, 3})
            .starts_with("the first minimum at 3 s is before the first sample at 10 s; "));
  CHECK(
      refusal_of_record(good, {4, 12}) ==
      "the load is 4 at 12 s, but between 3 and 4 in the cycle that begins there; give the time of its first minimum "
      "with --start, and its --period");
  Record flat = good;
  for (double& q : flat.load) q = 3;
  CHECK(refusal_of_record(flat, {4, 10})
            .starts_with("the load is 3 from 10 s to 14 s: there is no cycle in it; "));
  Record back = good;
  back.times[3] = back.times[2];
  CHECK(refusal_of_record(back, {4, 10}) == "time 11 follows 11; give times that increase");
  Record nan = good;
  nan.strain[4] = std::nan("");
  CHECK(refusal_of_record(nan, {4, 10}) == "sample 4 is not finite; leave it out");
  nan.strain.pop_back();
  CHECK(refusal_of_record(nan, {4, 10}).ends_with("give one of each per sample"));
}
