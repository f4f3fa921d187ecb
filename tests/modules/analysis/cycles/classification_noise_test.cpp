#include <cmath>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/cycles/classification.hpp>

using scree::cycles::Class;
using scree::cycles::classify;
using scree::cycles::ClassOptions;

namespace {

constexpr int samples = 500;

// Number of samples with a wrong class.
struct Called {
  int ratcheting = 0, periodic = 0, falls = 0;  // falls: shakedown, creep or settling
};

// series: makes so many values with a generator of random numbers.
template <class Series>
Called called(std::size_t count, const Series& series) {
  ClassOptions options;
  options.drop = 0;
  Called sum;
  for (unsigned seed = 1; seed <= samples; ++seed) {
    std::mt19937_64 random(seed);
    std::vector<double> values = series(random, count);
    for (double& value : values) value *= 1e-7;
    const Class kind = classify(values, options).kind;
    sum.ratcheting += kind == Class::ratcheting || kind == Class::late_ratcheting;
    sum.periodic += kind == Class::periodic;
    sum.falls += kind == Class::shakedown || kind == Class::creep || kind == Class::settling;
  }
  return sum;
}

// The number of samples for a share, plus three standard deviations.
int at_most(double share) { return int(share * samples + 3 * std::sqrt(share * samples)); }

// Independent values from a distribution.
template <class Distribution>
auto independent(Distribution distribution) {
  return [distribution](std::mt19937_64& random, std::size_t count) {
    Distribution fresh = distribution;
    std::vector<double> values(count);
    for (double& value : values) value = fresh(random);
    return values;
  };
}

// Normal values plus a share of the value before; 1 is a random walk.
auto remembering(double part) {
  return [part](std::mt19937_64& random, std::size_t count) {
    std::normal_distribution<double> normal;
    std::vector<double> values(count);
    double value = part < 1 ? normal(random) / std::sqrt(1 - part * part) : 0;
    for (double& x : values) {
      x = value;
      value = part * value + normal(random);
    }
    return values;
  };
}

constexpr double significance = 0.005;  // of the two tests, the default

}  // namespace

TEST_CASE("of independent noise one in two hundred is called periodic, and again falling", "[noise]") {
  for (const std::size_t count : {17, 32, 72, 272}) {
    for (const Called& c : {called(count, independent(std::normal_distribution<double>())),
                            called(count, independent(std::uniform_real_distribution<double>())),
                            called(count, independent(std::exponential_distribution<double>()))}) {
      INFO(count << " values: " << c.ratcheting << " ratcheting, " << c.periodic << " periodic, " << c.falls
                 << " falling");
      CHECK(c.ratcheting == 0);
      CHECK(c.periodic <= at_most(significance));
      CHECK(c.falls <= at_most(significance));
    }
  }
}

TEST_CASE("noise that remembers the cycle before is no more often called periodic or falling", "[noise]") {
  for (const std::size_t count : {17, 32, 72, 272})
    for (const double part : {0.5, 0.9, 1.0}) {
      const Called c = called(count, remembering(part));
      INFO(count << " values that keep " << part << ": " << c.ratcheting << " ratcheting, " << c.periodic
                 << " periodic, " << c.falls << " falling");
      CHECK(c.periodic <= at_most(significance));
      CHECK(c.falls <= at_most(significance));
    }
}

TEST_CASE("a straight line under noise of twice its slope neither repeats nor slows down", "[noise]") {
  for (const std::size_t count : {17, 32, 72, 272}) {
    const Called c = called(count, [](std::mt19937_64& random, std::size_t n) {
      std::vector<double> values = remembering(0)(random, n);
      for (std::size_t k = 0; k < n; ++k) values[k] += 0.5 * double(k);
      return values;
    });
    INFO(count << " values: " << c.periodic << " periodic, " << c.falls << " falling");
    CHECK(c.periodic <= at_most(significance));
    CHECK(c.falls <= at_most(significance));
  }
}
