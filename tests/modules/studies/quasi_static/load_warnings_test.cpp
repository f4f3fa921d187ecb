#include "cycled_discs.hpp"

#include <atomic>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <scree/quasi_static/follow.hpp>

using namespace scree;
using namespace scree::test;

TEST_CASE("a load that changes is seen to change, however many cycles there are") {
  const TemporaryFolder folder;
  for (const unsigned cycles : {9'999u, 10'000u, 20'000u}) {
    INFO(cycles);
    const scenario::Plan plan =
        scenario::read_plan(SCREE_TEST_SOURCE "/scenarios/mcnamara2008/biaxial.toml",
                            {fmt::format("stage.cycles.cycles={}", cycles), "time.step=1e-3"}, host());
    std::atomic<bool> stop = false;
    const quasi_static::FollowedLoad load = quasi_static::follow(
        plan, {.out = folder / std::to_string(cycles),
               .on_progress = [&](double, double, const std::string& what) { stop = what == "quasi-static"; },
               .stop = &stop});
    CHECK(load.warnings.empty());
  }
}

TEST_CASE("a load that changes between the ends of increments is warned of") {
  const TemporaryFolder folder;
  for (const auto& [period, warned] :
       {std::pair{"0.25", true}, std::pair{"0.5", true}, std::pair{"5", false}}) {
    INFO(period);
    const scenario::Plan plan =
        scenario::read_plan(SCREE_TEST_SOURCE "/scenarios/mcnamara2008/biaxial.toml",
                            {"stage.cycles.cycles=2", "time.step=1e-3",
                             std::string("stage.cycles.set.box.stress_y_high.period=") + period},
                            host());
    std::atomic<bool> stop = false;
    const quasi_static::FollowedLoad load = quasi_static::follow(
        plan, {.out = folder / period,
               .on_progress = [&](double, double, const std::string& what) { stop = what == "quasi-static"; },
               .stop = &stop});
    REQUIRE(load.warnings.size() == std::size_t(warned));
    if (warned)
      CHECK_THAT(load.warnings[0],
                 Catch::StartsWith("a load changes within an increment of 0.25 s by ") &&
                     Catch::EndsWith("of the range of the loads, which is left out; give more --increments"));
  }
}

TEST_CASE("a law that integrates spins is warned of") {
  const TemporaryFolder folder;
  const scenario::Plan plan = scenario::read_plan(
      SCREE_TEST_SOURCE "/scenarios/mcnamara2008/biaxial.toml",
      {"stage.cycles.cycles=1", "time.step=1e-3", "contact.discs.plugin=disc_corrected"}, host());
  const quasi_static::FollowedLoad load =
      quasi_static::follow(plan, {.out = folder / "out", .increments = 8});
  REQUIRE(load.warnings.size() == 1);
  CHECK_THAT(load.warnings[0], Catch::Contains("contact law 'discs' integrates spins") &&
                                   Catch::Contains("; compare several --increments"));
}
