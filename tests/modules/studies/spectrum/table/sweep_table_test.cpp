#include "table_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("a sweep has 100 periods of 50 samples at each frequency, unless its table says otherwise",
          "[spectrum]") {
  using Sweep = spectrum::SweepSettings;
  const Sweep usual = spectrum::read_spectrum(plan_with_spectrum(driven))->sweep;
  CHECK(usual.periods == 100);
  CHECK(usual.analysed_periods == 60);
  CHECK(usual.samples_per_period == 50);
  CHECK(usual.direction == Sweep::Direction::up);
  const Sweep own =
      spectrum::read_spectrum(
          plan_with_spectrum(driven +
                             "[spectrum.sweep]\nperiods = 30\nanalysed_periods = 20\ndirection = 'both'\n"))
          ->sweep;
  CHECK(own.periods == 30);
  CHECK(own.analysed_periods == 20);
  CHECK(own.direction == Sweep::Direction::both);
}

TEST_CASE("a sweep that analyses more periods than it has is refused at its key", "[spectrum]") {
  const std::string line = refused(driven + "[spectrum.sweep]\nperiods = 20\nanalysed_periods = 30\n");
  INFO(line);
  CHECK((line.starts_with("scene.toml:29:") || line.starts_with("scene.toml:30:")));
}
