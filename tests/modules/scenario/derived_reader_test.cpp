#include "plan_support.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// The discs scene, with its probe energy, and lines of [derived] from line 28 on.
std::string deriving(const std::string& lines) { return std::string(discs) + "[derived]\n" + lines; }

std::string derived_refusal(const std::string& lines) { return refusal(deriving(lines)); }

// The unit of the first quantity.
std::string unit_of_first(const std::string& lines) {
  return scenario::configured(plan_of(deriving(lines)).probes.back(), 2).units()[0];
}

// In stages a and b, with probes that record in these alone.
std::string in_stages(const std::string& lines) {
  const std::string probe = "[[probe]]\nplugin = 'energy'\nevery = 1e-5\n";
  return with(discs, "duration = 1e-4\n", "") + probe + "name = 'one'\nstages = ['a']\n" + probe +
         "name = 'two'\nstages = ['b']\n" + "[derived]\n" + lines;
}

// The table until is the last of a stage.
std::string ended(const std::string& until) {
  return "[[stage]]\nname = 'a'\n" + until + "\n[[stage]]\nname = 'b'\nduration = 1e-4\n";
}

const std::string timed = ended("duration = 1e-4");

}  // namespace

TEST_CASE("derived quantities are the columns of a probe behind the others", "[scenario]") {
  const scenario::Plan plan = plan_of(deriving(
      "b = 'energy.kinetic_rotation / energy.kinetic_translation'\na = 'derived.b * energy.kinetic_translation'\n"));
  REQUIRE(plan.probes.size() == 2);
  const scenario::ProbePlan& derived = plan.probes[1];
  CHECK(derived.name == "derived");
  CHECK(derived.every == 2e-5);
  CHECK(derived.stages.empty());
  CHECK(derived.depth > plan.probes[0].depth);
  // Each column once.
  CHECK(derived.inputs.size() == 2);
  const Probe probe = scenario::configured(derived, 2);
  CHECK(probe.names() == std::vector<std::string>{"b", "a"});
  CHECK(probe.units() == std::vector<std::string>{"", "J"});
  CHECK_FALSE(probe.observes());
  CHECK(plan_of(discs).probes.size() == 1);
}

TEST_CASE("a quantity may have a unit and an interval of its own", "[scenario]") {
  CHECK(unit_of_first("a = { formula = 'energy.work', unit = 'Nm' }\n") == "Nm");
  CHECK(unit_of_first("a = { formula = 'energy.work', unit = '1' }\n") == "");
  CHECK(unit_of_first("a = { formula = 'energy.work + time', unit = 'J' }\n") == "J");
  CHECK(unit_of_first("a = 'energy.work / time'\n") == "J/s");
  const auto every = [](const std::string& text) { return plan_of(deriving(text)).probes.back().every; };
  CHECK(every("a = { formula = 'energy.work', every = 4e-5 }\n") == 4e-5);
  CHECK(every("a = { formula = 'energy.work', every = 4e-5 }\nb = 'energy.work'\n") == 2e-5);
  CHECK(every("a = { formula = 'energy.work', every = 1e-5 }\nb = 'energy.work'\n") == 1e-5);
  CHECK(plan_of("[[probe]]\nplugin = 'energy'\nname = 'fine'\nevery = 1e-5\n" +
                deriving("a = 'energy.work + fine.work'\n"))
            .probes.back()
            .every == 2e-5);  // the longest, at which both write
}

TEST_CASE("other probes may read a derived quantity", "[scenario]") {
  const scenario::Plan plan = plan_of(
      deriving("a = 'energy.kinetic_translation'\n") +
      "[[probe]]\nplugin = 'lock_in'\nof = 'derived.a'\nfrequency_hz = 1e4\nperiods = 0.9\nevery = 1e-4\n");
  CHECK(plan.probes[1].inputs[0].probe == 2);
  CHECK(scenario::configured(plan.probes[1], 2).units()[0] == "J");
}

TEST_CASE("a wrong formula is refused where it is wrong", "[scenario]") {
  CHECK(derived_refusal("a = \"energy.wrok / 2\"\n") ==
        "scene.toml:28:6: 'energy.wrok' is no column of the probe 'energy'; did you mean 'work'?");
  CHECK(derived_refusal("a = '2 * enrgy.work'\n") ==
        "scene.toml:28:10: no probe 'enrgy'; did you mean 'energy'?");
  CHECK(derived_refusal("a = { formula = 'sqr(energy.work)' }\n") ==
        "scene.toml:28:18: no function 'sqr'; did you mean 'sqrt'?");
  CHECK(derived_refusal("a = '(energy.work'\n") == "scene.toml:28:6: this '(' is not closed; add ')'");
  CHECK(derived_refusal("a = ''\n").starts_with("scene.toml:28:6: the formula is empty; "));
  CHECK(derived_refusal("a = '1 + energy.time'\n") ==
        "scene.toml:28:10: 'energy.time' is no column of the probe 'energy'; write time alone");
  CHECK(
      derived_refusal("a = 'energy.work + energy.work / time'\n") ==
      "scene.toml:28:18: '+' of the units J and J/s; give the quantity its unit, as { formula = \"...\", unit = "
      "\"Pa\" }, if this is meant");
  CHECK(derived_refusal("a = \"2 * \\u0028 1\"\n") ==
        "scene.toml:28:5: at character 5: this '(' is not closed; add ')'");
  CHECK(refusal(deriving("a = 'energy.work'\n"), {"derived.a=energy.work + x.y"}) ==
        "--set derived.a=energy.work + x.y: at character 15: no probe 'x'; there are: energy, derived");
  CHECK(derived_refusal("a = 3\n").starts_with("scene.toml:28:5: derived.a is an integer (3); "));
}

TEST_CASE("a formula that reads nothing, itself or what stands below is refused", "[scenario]") {
  CHECK(derived_refusal("a = '2 * time'\n") ==
        "scene.toml:28:5: the formula of 'a' reads no column; name one, as <probe>.<column>");
  CHECK(derived_refusal("a = '1 + derived.a'\n") ==
        "scene.toml:28:10: the quantity 'a' reads itself; name another column");
  CHECK(derived_refusal("a = 'derived.b'\nb = 'energy.work'\n") ==
        "scene.toml:28:6: 'a' reads 'b', which stands below it; exchange them");
  CHECK(derived_refusal("abc = 'energy.work'\nb = 'derived.abd'\n") ==
        "scene.toml:29:6: no derived quantity 'abd'; did you mean 'abc'?");
  CHECK(
      derived_refusal(
          "a = 'lock_in.mean'\n[[probe]]\nplugin = 'lock_in'\nof = 'derived.a'\nfrequency_hz = 1e4\n"
          "periods = 0.9\nevery = 1e-4\n") ==
      "scene.toml:31:6: the probes lock_in, derived read columns of each other in a circle; let one of them read a "
      "column of another probe");
}

TEST_CASE("names, units and keys of derived quantities are checked", "[scenario]") {
  CHECK(derived_refusal("").starts_with("scene.toml:27:1: the table [derived] has no quantity; "));
  CHECK(
      derived_refusal("'a b' = 'energy.work'\n") ==
      "scene.toml:28:9: 'a b' cannot name a derived quantity; begin with a letter, and use less than 64 letters, "
      "digits and '_'");
  CHECK(derived_refusal("1a = 'energy.work'\n").find("cannot name a derived quantity") != std::string::npos);
  CHECK(derived_refusal("time = 'energy.work'\n") ==
        "scene.toml:28:8: every series has a column 'time' already; give another name");
  CHECK(
      derived_refusal("a = { formula = 'energy.work', unit = 'J,m' }\n") ==
      "scene.toml:28:39: 'J,m' cannot stand in the header of a series; use less than 64 bytes, without commas, "
      "quotes and brackets");
  CHECK(derived_refusal("a = { formla = 'energy.work' }\n").find("correct 'formla' (scene.toml:28:7)") !=
        std::string::npos);
  CHECK(
      derived_refusal("a = { formula = 'energy.work', units = 'J' }\n") ==
      "scene.toml:28:32: unknown key 'units' in [derived.a]; did you mean 'unit'? known keys: formula, unit, every");
  CHECK(
      derived_refusal("a = { formula = 'energy.work', every = 1e-6 }\n").find("shorter than the time step") !=
      std::string::npos);
  CHECK(
      refusal(deriving("a = 'energy.work'\n"), {"probe.name=derived"}) ==
      "--set probe.name=derived: the probe has the name 'derived' of the series of [derived]; give it another name");
}

TEST_CASE("a quantity has values in the stages in which all records that it reads", "[scenario]") {
  const scenario::Plan plan =
      plan_of(in_stages("a = 'one.work'\nb = 'two.work'\nc = 'energy.work'\n") + timed);
  const scenario::ProbePlan& derived = plan.probes.back();
  using Names = std::vector<std::string>;
  CHECK(derived.stages.empty());
  CHECK(derived.stages_of(0) == Names{"a"});
  CHECK(derived.stages_of(1) == Names{"b"});
  CHECK(derived.stages_of(2).empty());
  CHECK(plan_of(in_stages("a = 'one.work'\nb = 'derived.a'\n") + timed).probes.back().stages == Names{"a"});
  CHECK(
      refusal(in_stages("a = 'one.work'\nb = 'derived.a - two.work'\n") + timed) ==
      "scene.toml:38:5: the probes that 'b' reads record in no stage together; give them a stage in common");
  const auto conditioned = [](const std::string& column) {
    return in_stages("a = 'one.work'\nb = 'two.work'\n") +
           ended("until = { 'derived." + column + "' = { above = 1 }, at_most = 1e-4 }");
  };
  CHECK(refusal(conditioned("a")) == "no error");
  CHECK(
      refusal(conditioned("b"))
          .find(
              "a probe that 'derived.b' reads does not record in stage 'a'; add the stage to its 'stages'") !=
      std::string::npos);
  const std::string reader = "[[probe]]\nplugin = 'arrival'\nof = 'derived.a'\nthreshold = 1\nevery = 1e-5\n";
  CHECK(refusal(in_stages("a = 'one.work'\nb = 'two.work'\n") + reader + timed)
            .find("the probe 'derived' does not record in stage 'b', in which 'arrival' does") !=
        std::string::npos);
}

TEST_CASE("columns and their order survive the resolved text", "[scenario]") {
  const scenario::Plan plan = plan_of(deriving("[derived.z]\nformula = 'energy.work'\nunit = 'Nm'\n") +
                                          "[derived.a]\nformula = 'derived.z / time'\nevery = 1e-5\n",
                                      {"derived.c=min(energy.work, -pi)"});
  const scenario::Plan again = plan_of(plan.resolved_text);
  const Probe probe = scenario::configured(plan.probes.back(), 2);
  CHECK(probe.names() == std::vector<std::string>{"c", "z", "a"});
  CHECK(scenario::configured(again.probes.back(), 2).names() == probe.names());
  CHECK(scenario::configured(again.probes.back(), 2).units() == probe.units());
}

TEST_CASE("charts, conditions and expectations know derived quantities", "[scenario]") {
  const std::string text = deriving("strain = '1 - energy.work / energy.potential'\nq = 'energy.work * 2'\n");
  const scenario::Plan plan =
      plan_of(text +
              "[[chart]]\nname = 'c'\nx = 'derived.strain'\ny = 'derived.q'\n"
              "[[expect]]\nrequirement = 'r'\nquantity = 'derived.q.max'\nat_most = 1\n");
  CHECK(plan.charts[0].curves[0].probe == "derived");
  CHECK(plan.charts[0].curves[0].x == "strain");
  CHECK(plan.charts[0].curves[0].y == "q");
  CHECK(plan.charts[0].y_unit == "J");
  REQUIRE(plan.expectations.size() == 1);
  CHECK(refusal(text + "[[expect]]\nrequirement = 'r'\nquantity = 'derived.p.max'\nat_most = 1\n")
            .find("no quantity 'derived.p.max'; did you mean 'derived.q.max'?") != std::string::npos);
}
