#include "noise.hpp"

#include <cstddef>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/cycles/classification.hpp>

using namespace scree::cycles;
using namespace scree::test;

namespace {

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
