#include "plan_support.hpp"

#include <catch2/catch.hpp>

#include <scree/probes.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;

namespace {

// The discs scene, which has the probe energy, with a stage.
std::string ending(const std::string& until, const std::string& probe = "") {
  return with(discs, "duration = 1e-4\n", "") + probe + "[[stage]]\nname = 'press'\nuntil = { " + until +
         " }\n";
}

Until until_of(const std::string& text) { return plan_of(ending(text)).stages[0].until; }

}  // namespace

TEST_CASE("a stage ends by columns of probes, all of them or any", "[scenario]") {
  const Until until = until_of(
      "'energy.elastic_normal' = { above = 1e-3, below = 2 }, kinetic_over_elastic = 1e-4, "
      "'energy.work' = { steady = 0.01, over = 0.2 }, at_most = 2, otherwise = 'go_on'");
  REQUIRE(until.conditions.size() == 3);
  CHECK(until.reads_energies());
  CHECK(until.reads_columns());
  CHECK_FALSE(until.any);
  CHECK(until.goes_on);
  const Condition& elastic = until.conditions[1];
  CHECK(elastic.name == "energy.elastic_normal");
  CHECK(elastic.unit == "J");
  CHECK(elastic.probe == 0);
  CHECK(elastic.above == 1e-3);
  CHECK(elastic.below == 2);
  CHECK(until.conditions[2].steady == 0.01);
  CHECK(until.conditions[2].over == 0.2);
  CHECK(
      until.text() ==
      "kinetic_over_elastic below 0.0001 and energy.elastic_normal above 0.001 and below 2 and energy.work steady "
      "within 0.01 over 0.2 s");
  // As TOML nests a name without quotes.
  const Until any = until_of("energy.work = { below = 1 }, match = 'any', at_most = 2");
  CHECK(any.any);
  CHECK_FALSE(any.goes_on);
  CHECK(any.conditions.at(0).name == "energy.work");
}

TEST_CASE("the column of a condition is that of the row", "[scenario]") {
  const Plan plan = plan_of(ending("'energy.kinetic_rotation' = { below = 1 }, at_most = 2"));
  const Condition& c = plan.stages[0].until.conditions.at(0);
  const Probe probe(plan.probes[c.probe].parameters, 2);
  CHECK(probe.names()[c.column] == "kinetic_rotation");
}

TEST_CASE("conditions that no run can test are refused with the place and the nearest name", "[scenario]") {
  const auto refused = [](const std::string& until, const std::string& message,
                          const std::string& probe = "") {
    CHECK_THAT(refusal(ending(until, probe)), Catch::StartsWith("scene.toml:") && Catch::Contains(message));
  };
  refused("'enery.work' = { above = 1 }, at_most = 1", "no probe 'enery'; did you mean 'energy'?");
  refused("'energy.wrok' = { above = 1 }, at_most = 1", "no column 'wrok'; did you mean 'work'?");
  refused("'energy.time' = { above = 1 }, at_most = 1", "time is no condition of a stage; give duration");
  refused("'energy.work' = 1, at_most = 1", "'energy.work' is not a table; give the name of a [[probe]]");
  refused("'energy.work' = { }, at_most = 1", "the condition on 'energy.work' has no bound; give above");
  refused("'energy.work' = { abov = 1, below = 2 }, at_most = 1", "did you mean 'above'?");
  refused("'energy.work' = { above = 2, below = 1 }, at_most = 1", "above = 2 is not less than below = 1");
  refused("'energy.work' = { steady = 0.1 }, at_most = 1", "has no 'over'");
  refused("'energy.work' = { above = 1, over = 0.1 }, at_most = 1", "'over' is the time of 'steady'");
  refused("'energy.work' = { abov = 1 }, at_most = 1", "did you mean 'above'?");
  refused("energy = { below = 1 }, at_most = 1",
          "'energy' is not a column of a probe; give one of its columns, as \"energy.<column>\"");
  refused("'energy.work' = { steady = 0.1, over = 1 }, at_most = 1", "over = 1 s is not below at_most = 1 s");
  refused("'energy.work' = { above = 1 }, at_most = 1e-5",
          "'energy' is sampled every 2e-05 s, which is more than at_most = 1e-05 s");
  refused("'energy.work' = { steady = 0.1, over = 1e-5 }, at_most = 1",
          "over = 1e-05 s is shorter than the 2e-05 s between samples of 'energy'");
  refused("'energy.work' = { above = 1 }, energy.work = { below = 2 }, at_most = 1",
          "'energy.work' has two conditions");
  refused("'energy.work' = { above = 1 }", "has no 'at_most'");
  refused("at_most = 1", "the stage has no condition; give kinetic_over_elastic");
  refused("kinetic_over_elastik = 1e-3, at_most = 1", "did you mean 'kinetic_over_elastic'?");
  refused("kinetic_over_elastic = 1e-3, otherwise = 'goon', at_most = 1", "go_on");
  refused("kinetic_over_elastic = 1e-3, match = 'some', at_most = 1", "any");
  refused("'energy.work' = { above = 1 }, at_most = 1", "the probe 'energy' does not record in stage 'press'",
          "stages = ['later']\n[[stage]]\nname = 'later'\nduration = 1\n");
  CHECK_THAT(
      refusal(with(with(discs, "duration = 1e-4\n", ""), "[[probe]]\nplugin = 'energy'\nevery = 2e-5\n", "") +
              "[[stage]]\nuntil = { 'stress.zz' = { above = 1 }, at_most = 1 }\n"),
      Catch::Contains("'stress.zz' is a column of a probe, and the scene has none; add a [[probe]]"));
}
