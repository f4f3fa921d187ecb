#include "noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/cycles/classification.hpp>
#include <scree/error.hpp>

using scree::cycles::Class;
using scree::cycles::Classification;
using scree::cycles::classify;
using scree::cycles::ClassOptions;
using scree::cycles::Slowing;

namespace {

constexpr std::size_t strain_minima = 101;  // of which the last 72 count

// A strain at minima 0, 1, ... with normal noise.
template <class Strain>
std::vector<double> series(const Strain& strain, double noise = 0, unsigned seed = 1,
                           std::size_t count = strain_minima) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values;
  for (std::size_t n = 0; n < count; ++n) values.push_back(strain(double(n)) + noise * normal(random));
  return values;
}

// How many of 200 series with different noise have a class.
template <class Strain>
int of_200(Class kind, const Strain& strain, double noise) {
  if (noise == 0) return 200 * (classify(series(strain)).kind == kind);
  int count = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const Classification c = classify(series(strain, noise, seed));
    if (c.kind != kind && count < 3) UNSCOPED_INFO(class_name(c.kind) << ": " << c.reason);
    count += c.kind == kind;
  }
  return count;
}

std::string refusal_of_strain(const std::vector<double>& strain, const ClassOptions& options = {}) {
  try {
    classify(strain, options);
  } catch (const scree::Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a strain within round-off is constant, also on a large mean", "[classification]") {
  const Classification c = classify(series([](double n) { return 1e-3 + (n > 70 ? 7e-16 : 0); }));
  CHECK(c.kind == Class::constant);
  CHECK(c.range == Approx(7e-16).epsilon(0.4));  // units in the last place of 1e-3: 2.2e-19
  CHECK(c.reason == "the strain stays within 7.00e-16, at most the round-off 1.00e-13");
  CHECK(classify(series([](double n) { return 2e3 + 1e-11 * std::sin(n); })).kind == Class::constant);
  CHECK(classify(series([](double n) { return 2e-12 * std::sin(n * n); })).kind != Class::constant);
  ClassOptions coarse;
  coarse.round_off = 1e-11;
  CHECK(classify(series([](double n) { return 2e-12 * std::sin(n * n); }), coarse).kind == Class::constant);
}

TEST_CASE("a straight line ratchets until its deviations exceed its slope", "[classification]") {
  const Classification exact = classify(series([](double n) { return 0.5 - 2e-9 * n; }));
  CHECK(exact.kind == Class::ratcheting);
  // Round-off of values of 0.5, 1.1e-16, over some cycles.
  CHECK(exact.line.slope == Approx(-2e-9).epsilon(1e-8));
  CHECK(exact.line.intercept == Approx(0.5).epsilon(1e-13));
  CHECK(exact.line.rms < 1e-15);
  // The deviation of the rms of 72 is 8 %: 0.7 and 1.4 slopes are more than three of these from 1.
  CHECK(of_200(
            Class::ratcheting, [](double n) { return 2e-9 * n; }, 1.4e-9) == 200);
  CHECK(of_200(
            Class::ratcheting, [](double n) { return 2e-9 * n; }, 2.8e-9) == 0);
}

TEST_CASE("a strain that repeats is periodic, with its shortest period", "[classification]") {
  const auto wave = [](double period) {
    return [period](double n) { return 1e-6 * std::cos(2 * std::numbers::pi * (n + 0.3) / period); };
  };
  for (const double period : {2, 3, 7, 24}) {
    CHECK(of_200(Class::periodic, wave(period), 2e-7) >= 199);
    const Classification c = classify(series(wave(period)));
    CHECK(c.kind == Class::periodic);
    CHECK(double(c.period) == period);
  }
  const Classification peaks =
      classify(series([](double n) { return std::fmod(n, 5) == 0 ? 1e-8 : 0; }, 1e-14));
  CHECK(peaks.kind == Class::periodic);
  CHECK(peaks.period == 5);
  const Classification tilted =
      classify(series([](double n) { return 1e-8 * n + (std::fmod(n, 2) == 0 ? 1e-6 : 0); }));
  CHECK(tilted.kind == Class::periodic);
  CHECK(tilted.robust.slope == Approx(1e-8).epsilon(0.01));
  // On a drift that wanders by half the amplitude in 25 cycles.
  int over_drift = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::vector<double> drift = series([](double) { return 0.0; }, 1e-7, seed);
    std::partial_sum(drift.begin(), drift.end(), drift.begin());
    const auto both = [&](double n) { return drift[std::size_t(n)] + wave(4)(n); };
    over_drift += classify(series(both)).period == 4;
  }
  CHECK(over_drift == 200);
}

TEST_CASE("a value that stands off neither hides a repetition nor makes one", "[classification]") {
  const auto single = [](double n) { return n == 95 ? 1.0 : 1e-9 * std::fmod(n, 2); };
  const Classification hidden = classify(series(single));
  CHECK(hidden.kind == Class::periodic);
  CHECK(hidden.period == 2);
  CHECK(hidden.outliers == std::vector<std::size_t>{95});
  const auto two = [](double n) { return n == 50 || n == 60 ? 1e-6 : 0.0; };
  CHECK(of_200(Class::outliers, two, 1e-10) >=
        196);  // 0.5 % pass for periodic: 1 of 200, and three standard deviations
}

TEST_CASE("single cycles that stand off are outliers, and are listed", "[classification]") {
  const auto spikes = [](double n) {
    return (n == 42 ? 3e-8 : n == 63 ? -5.6e-7 : n == 64 ? -1e-9 : n == 80 ? 2e-9 : 0.0);
  };
  const std::vector<std::size_t> places = {42, 63, 64, 80};
  const Classification flat = classify(series(spikes, 1e-16));
  CHECK(flat.kind == Class::outliers);
  CHECK(flat.outliers == places);
  const Classification inclined =
      classify(series([&](double n) { return 1e-9 * n + 30 * spikes(n); }, 1e-12));
  CHECK(inclined.kind == Class::outliers);
  CHECK(inclined.outliers == places);
  CHECK(inclined.robust.slope == Approx(1e-9).epsilon(1e-3));
  const Classification decaying =
      classify(series([&](double n) { return 1e-9 * std::exp(-n / 12) + 30 * spikes(n); }));
  CHECK(decaying.kind == Class::outliers);
  CHECK(decaying.outliers == places);
  CHECK(of_200(
            Class::outliers, [&](double n) { return spikes(n); }, 5e-11) >= 196);
  // In noise no cycle stands off: ten deviations are improbable for normal noise.
  CHECK(of_200(
            Class::outliers, [](double) { return 0.0; }, 1e-9) == 0);
  // A step and a decay without noise have no cycle that stands off.
  CHECK(classify(series([](double n) { return n < 60 ? 0 : 1e-6; })).outliers.empty());
  CHECK(classify(series([](double n) { return std::exp(-(n - 29) / 5); })).outliers.empty());
  // Thirty of a hundred are too many for outliers.
  const Classification many =
      classify(series([](double n) { return std::sin(n * n) > 0.6 ? 1e-8 : 0; }, 1e-13));
  CHECK(many.kind != Class::outliers);
}

TEST_CASE("a strain whose increments fall shakes down", "[classification]") {
  // 0.5 % of noise pass for periodic, so that 196 of 200 remain, as above.
  const auto exponential = [](double n) { return 1e-4 * (1 - std::exp(-(n - 29) / 10)); };
  const auto power = [](double n) { return 1e-4 * std::pow(n + 1, -0.5); };
  for (const double noise : {0.0, 1e-7}) {
    CHECK(of_200(Class::shakedown, exponential, noise) >= 196);
    CHECK(of_200(Class::shakedown, power, noise / 10) >= 196);
  }
  CHECK(classify(series(exponential)).settling_probability < 1e-6);
  // Noise of 1e-9 hides single increments, not those of means over blocks. Nine of ten must be found, less
  // three standard deviations of such a number of 200.
  CHECK(of_200(
            Class::shakedown, [](double n) { return 5e-8 * std::exp(-(n - 29) / 40); }, 1e-9) >= 180 - 13);
  // Growing increments are no shakedown.
  CHECK(of_200(
            Class::shakedown, [](double n) { return 1e-4 * std::exp((n - 100) / 10); }, 1e-7) == 0);
}

TEST_CASE("a strain that goes on without a limit creeps, with its law", "[classification]") {
  using Law = Slowing::Law;
  const auto logarithm = [](double n) { return 1e-6 * std::log(1 + std::max(0.0, n - 28)); };
  const auto root = [](double n) { return 1e-6 * std::sqrt(n + 1); };
  for (const double noise : {0.0, 1e-9}) {
    CHECK(of_200(Class::creep, logarithm, noise) >= 196);
    CHECK(of_200(Class::creep, root, noise) >= 196);
  }
  const Classification c = classify(series(logarithm)), d = classify(series(root));
  CHECK(c.slowing->law == Law::logarithm);
  CHECK(c.slowing->amplitude == Approx(1e-6).epsilon(1e-3));  // a fit to 0.001 of its scale
  CHECK(c.slowing->scale == Approx(2).epsilon(1e-3));         // log(2 + k)
  CHECK(c.reason.starts_with("1.000e-06 log(1 + k/2), criterion of Akaike lower by "));
  CHECK(d.slowing->law == Law::power);
  CHECK(d.slowing->exponent == Approx(0.5).epsilon(0.01));
  // A law with a limit.
  const Classification e = classify(series([](double n) { return 3e-4 - 1e-4 * std::exp(-(n - 29) / 10); }));
  CHECK(e.kind == Class::shakedown);
  CHECK(e.slowing->law == Law::exponential);
  CHECK(e.slowing->scale == Approx(10).epsilon(1e-3));
  CHECK(e.slowing->constant == Approx(3e-4).epsilon(1e-3));
}

TEST_CASE("a strain that slows down under noise too large for its law settles", "[classification]") {
  // Over 72 cycles a logarithm that began 150 before has the curvature of an exponential: their difference is
  // a small part of its range.
  const auto late = [](double n) { return 1e-6 * std::log(n + 121); };
  int settling = 0, creep = 0, shakedown = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const Class kind = classify(series(late, 2e-8, seed)).kind;
    settling += kind == Class::settling, creep += kind == Class::creep, shakedown += kind == Class::shakedown;
  }
  // A law that is exp(3/2) times as likely as another is wrong in at most one of 1 + exp(3/2) series.
  CHECK(shakedown <= 200 / (1 + std::exp(1.5)));
  CHECK(settling > creep + shakedown);
}

TEST_CASE("a straight line behind a settling part ratchets late", "[classification]") {
  // 272 cycles that count, of which the first 50 settle against the line or with it.
  constexpr std::size_t count = 301;
  for (const double settling : {1e-6, -1e-6}) {
    const auto line = [&](double n) { return 1e-8 * n + settling * std::exp(-(n - 29) / 5); };
    for (unsigned seed = 1; seed <= 20; ++seed)
      CHECK(classify(series(line, 2e-9, seed, count)).kind == Class::late_ratcheting);
    const Classification c = classify(series(line, 0, 1, count));
    // The settling part adds less than a cycle of the line after 5 log(100) cycles.
    CHECK(c.ratchets_from == 29 + 24);
    CHECK(c.after_settling.slope == Approx(1e-8).epsilon(1e-3));
    CHECK(c.reason.starts_with("settles until cycle 53; from there deviations of "));
  }
  // A settling part of two time constants has no straight line after it.
  const Classification both = classify(
      series([](double n) { return 1e-6 * (std::exp(-(n - 29) / 5) + 0.5 * std::exp(-(n - 29) / 40)); }));
  CHECK(both.kind == Class::shakedown);
}

TEST_CASE("noise is irregular, and the reason names all that was tried", "[classification]") {
  const Classification c = classify(series([](double) { return 0.0; }, 1e-7, 3));
  CHECK(c.kind == Class::irregular);
  CHECK(c.reason.starts_with("deviations of "));
  CHECK(c.reason.find("both above 0.005; 0 cycles stand off") != std::string::npos);
  // A transient within the cycles that count.
  const Classification late = classify(series([](double n) { return n < 50 ? 0 : 1e-8 * (n - 50); }));
  CHECK(late.kind == Class::irregular);
  CHECK(late.reason.find("; the last 36 alone ratchet by 1.000e-08 per cycle") != std::string::npos);
}

TEST_CASE("a strain that cannot be classified is refused in one line", "[classification]") {
  const auto flat = [](double) { return 0.0; };
  CHECK(
      refusal_of_strain(series(flat, 0, 1, 44)) ==
      "43 cycles, the first 29 of which are dropped: too few for a verdict; give 44 cycles or more, or drop fewer");
  CHECK(refusal_of_strain(series(flat, 0, 1, 45)).empty());
  CHECK(refusal_of_strain({}).starts_with("0 cycles, the first 29 of which are dropped"));
  CHECK(refusal_of_strain(series([](double n) { return n == 7 ? std::nan("") : 0; })) ==
        "the strain of cycle 7 is not finite; leave it out");
  ClassOptions options;
  options.significance = 0;
  CHECK(refusal_of_strain(series(flat), options).ends_with("give 0 or more, 0 to 1, above 0, and 0 or more"));
}

// By chance one in two hundred is called periodic, and again one falling, and three standard deviations more
// of each.

namespace {

using namespace scree::test;

// Number of samples with a wrong class.
struct WrongClasses {
  int ratcheting = 0, periodic = 0, falls = 0;  // falls: shakedown, creep or settling
};

WrongClasses wrong_classes(std::size_t count, const Series& series) {
  ClassOptions options;
  options.drop = 0;
  WrongClasses sum;
  called(count, series, [&](std::vector<double> values) {
    for (double& value : values) value *= 1e-7;
    const Class kind = classify(values, options).kind;
    sum.ratcheting += kind == Class::ratcheting || kind == Class::late_ratcheting;
    sum.periodic += kind == Class::periodic;
    sum.falls += kind == Class::shakedown || kind == Class::creep || kind == Class::settling;
    return false;
  });
  return sum;
}

constexpr std::size_t counts[] = {17, 32, 72, 272};

}  // namespace

TEST_CASE("of independent noise one in two hundred is called periodic, again falling, and none ratcheting",
          "[noise]") {
  for (const std::size_t count : counts)
    for (const Series& noise : {independent(std::normal_distribution<double>()),
                                independent(std::uniform_real_distribution<double>()),
                                independent(std::exponential_distribution<double>())}) {
      const WrongClasses c = wrong_classes(count, noise);
      INFO(count << " values");
      CHECK(c.ratcheting == 0);
      CHECK(c.periodic <= at_most(significance));
      CHECK(c.falls <= at_most(significance));
    }
}

TEST_CASE("noise that remembers the cycle before is no more often called periodic or falling", "[noise]") {
  for (const std::size_t count : counts)
    for (const double part : {0.5, 0.9, 1.0}) {
      const WrongClasses c = wrong_classes(count, remembering(part));
      INFO(count << " values that keep " << part);
      CHECK(c.periodic <= at_most(significance));
      CHECK(c.falls <= at_most(significance));
    }
}

TEST_CASE("a straight line under noise of twice its slope neither repeats nor slows down", "[noise]") {
  for (const std::size_t count : counts) {
    const WrongClasses c = wrong_classes(count, [](std::mt19937_64& random, std::size_t n) {
      std::vector<double> values = remembering(0)(random, n);
      for (std::size_t k = 0; k < n; ++k) values[k] += 0.5 * double(k);
      return values;
    });
    INFO(count << " values");
    CHECK(c.periodic <= at_most(significance));
    CHECK(c.falls <= at_most(significance));
  }
}
