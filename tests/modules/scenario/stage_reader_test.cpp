#include "plan_support.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

using namespace scree;
using namespace scree::scenario;
using namespace scree::test;

namespace {

// The discs scene with stages instead of a duration; the first stage begins in line 26.
std::string staged(const std::string& stages) { return with(discs, "duration = 1e-4\n", "") + stages; }

}  // namespace

TEST_CASE("stages end by a duration, by cycles or by a condition", "[scenario]") {
  const std::vector<Stage> stages =
      plan_of(staged("[[stage]]\nduration = 0.5\n"
                     "[[stage]]\nname = 'cycle'\ncycles = 2.5\nperiod = 0.1\n"
                     "[[stage]]\nuntil = { kinetic_over_elastic = 1e-6, at_least = 0.1, at_most = 5 }\n"))
          .stages;
  REQUIRE(stages.size() == 3);
  CHECK(stages[0].name == "stage 1");
  CHECK(stages[0].duration == 0.5);
  CHECK(stages[1].name == "cycle");
  CHECK(stages[1].duration == Approx(0.25));
  CHECK_FALSE(stages[2].duration);
  REQUIRE(stages[2].until.conditions.size() == 1);
  CHECK(stages[2].until.conditions[0].below == 1e-6);
  CHECK(stages[2].until.at_least == 0.1);
  CHECK(stages[2].until.at_most == 5);
}

TEST_CASE("a change by a stage persists in the following stages", "[scenario]") {
  const std::string law = "set.linear_spring_dashpot.";
  const std::vector<Stage> stages =
      plan_of(staged("[[stage]]\nduration = 1\n" + law + "normal_stiffness = 5e3\n[[stage]]\nduration = 1\n" +
                     law + "normal_damping = 0.5\n[[stage]]\nduration = 1\n"))
          .stages;
  REQUIRE(stages.size() == 3);
  REQUIRE(stages[1].changes.size() == 1);
  CHECK(stages[1].changes[0].kind == SCREE_CONTACT_LAW);
  const std::vector<scree_value> values = stages[1].changes[0].parameters.values();
  CHECK(values[0].data[0] == 5e3);  // normal_stiffness
  CHECK(values[1].data[0] == 0.5);  // normal_damping
  CHECK(stages[2].changes.empty());
}

TEST_CASE("a stage that cannot end is refused", "[scenario]") {
  CHECK(refusal(staged("[[stage]]\n"))
            .starts_with("scene.toml:26:1: the stage has no end condition; give one of "));
  CHECK(refusal(staged("[[stage]]\nduration = 1\ncycles = 1\n"))
            .starts_with("scene.toml:26:1: the stage has more than one end condition; "));
  CHECK(refusal(staged("[[stage]]\ncycles = 1\n")).starts_with("scene.toml:26:1: [[stage]] has no 'period'"));
  CHECK(refusal(staged("[[stage]]\nduration = 1\nperiod = 0.1\n"))
            .starts_with(
                "scene.toml:28:10: 'period' is the length of the 'cycles', which are not given; add "));
  CHECK(refusal(staged("[[stage]]\nuntil = { kinetic_over_elastic = 1e-6 }\n"))
            .starts_with("scene.toml:27:9: [stage.until] has no 'at_most'"));
  CHECK(refusal(staged("[[stage]]\nuntil = { kinetic_over_elastic = 1e-6, at_least = 2, at_most = 1 }\n")) ==
        "scene.toml:27:51: at_least = 2 s is not below at_most = 1 s; give a smaller at_least or a larger "
        "at_most");
  CHECK(refusal(staged("[[stage]]\nduration = 1e-7\n")) ==
        "scene.toml:27:12: 1e-07 s is shorter than the time step of 1e-05 s; increase it, or decrease "
        "time.step");
  CHECK(refusal(staged("[[stage]]\nduration = 1e9\n"))
            .starts_with("scene.toml:27:12: 1e+09 s takes 1e+14 time steps of 1e-05 s; "));
}

TEST_CASE("a stage that changes something unknown or fixed is refused", "[scenario]") {
  const std::string stage = "[[stage]]\nduration = 1\n";
  CHECK(refusal(staged(stage + "set.boxx.gap = 1\n")) ==
        "scene.toml:28:5: no law, boundary or body force 'boxx'; did you mean 'box'?");
  CHECK(refusal(staged(stage + "set.box.frob = 1\n")).starts_with("scene.toml:28:9: unknown key 'frob' in "));
  CHECK(refusal(staged(stage + "set.box.x_low = 'stress'\n"))
            .find("a stress-controlled wall has no stress; give stress = <Pa>") != std::string::npos);
  const std::string box =
      "plugin = 'box'\nx_low = 'fixed'\nx_high = 'fixed'\ny_low = 'fixed'\ny_high = 'fixed'\ngap = 0.005\n";
  const std::string periodic = with(staged(stage + "set.periodic.upper = [2, 0]\n"), box,
                                    "plugin = 'periodic'\naxes = 'x'\nlower = [0, 0]\nupper = [1, 0]\n");
  CHECK(refusal(periodic).find("a stage cannot change the number of walls or the periodic axes") !=
        std::string::npos);
  CHECK(refusal(staged(stage + "name = 'a'\n" + stage + "name = 'a'\n")) ==
        "scene.toml:31:8: the stage name 'a' is already in use; give each a different name");
  CHECK(refusal(discs + stage) ==
        "scene.toml:5:12: both stages and time.duration are given; keep [[stage]] or time.duration");
}

TEST_CASE("functions of time that a stage does not set go on", "[scenario]") {
  const std::string scene = with(discs, "duration = 1e-4\n", "") +
                            "[[boundary]]\nplugin = 'box'\nname = 'cell'\ngap = 0.01\nx = 'fixed'\n"
                            "stress_y = { from = 10, to = 20, duration = 1 }\nstress_z_low = 3\n"
                            "[[body_force]]\nplugin = 'gravity'\nacceleration = [0, 0]\n"
                            "acceleration_y = { amplitude = 1, frequency_hz = 1 }\n";
  const std::string first = "[[stage]]\nduration = 0.5\n",
                    second = "[[stage]]\nname = 'two'\nduration = 0.5\n";
  const auto going_on = [&](const std::string& set) {
    const Plan plan = plan_of(scene + first + second + set);
    CHECK(plan.warnings.empty());
    REQUIRE(plan.stages[1].changes.size() == 1);
    return plan.stages[1].changes[0].going_on;
  };
  using Keys = std::vector<std::string>;
  CHECK(going_on("set.cell = { viscosity = 1 }\n") == Keys{"stress_y"});
  CHECK(going_on("set.cell = { stress_y = { from = 10, to = 20, duration = 1 } }\n").empty());
  CHECK(going_on("set.gravity = { acceleration = [1, 0] }\n") == Keys{"acceleration_y"});
  // A function that is followed from this stage on begins with it.
  const std::string lid = with(discs, "duration = 1e-4\n", "") +
                          "[[boundary]]\nplugin = 'plane'\nname = 'lid'\npoint = [0, 9]\nnormal = [0, -1]\n"
                          "control = 'fixed'\nvelocity = { from = 0, to = 1, duration = 1 }\n";
  CHECK(
      plan_of(lid + first + second + "set.lid.control = 'velocity'\n").stages[1].changes[0].going_on.empty());
}

TEST_CASE("laws and body forces can be absent from a stage on, and come back", "[scenario]") {
  const std::string first = "[[stage]]\nduration = 0.5\n",
                    second = "[[stage]]\nname = 'two'\nduration = 0.5\n";
  const std::string scene =
      with(discs, "duration = 1e-4\n", "") +
      "[[body_force]]\nplugin = 'gravity'\nacceleration = [0, -1]\ncontrol = 'absent'\n";
  const Plan plan =
      plan_of(scene + first + second +
              "set.gravity.control = 'present'\nset.linear_spring_dashpot.control = 'absent'\n");
  CHECK(plan.scene.body_forces[0].parameters.absent());
  CHECK_FALSE(plan.scene.laws[0].parameters.absent());
  REQUIRE(plan.stages[1].changes.size() == 2);
  for (const Stage::Change& change : plan.stages[1].changes)
    CHECK(change.parameters.absent() == (change.kind == SCREE_CONTACT_LAW));
  CHECK_THAT(refusal(scene + first + "set.gravity.control = 'off'\n"),
             Catch::Contains("present") && Catch::Contains("absent"));
}

TEST_CASE("cycles whose period is no number of steps are warned of", "[scenario]") {
  const std::string box = with(discs, "duration = 1e-4\n", "");
  const auto warnings = [&](const std::string& stage) {
    return plan_of(box + "[[stage]]\n" + stage, {"time.step=1e-5"}).warnings;
  };
  CHECK(warnings("cycles = 5\nperiod = 0.01\n").empty());
  CHECK(warnings("cycles = 1\nperiod = 0.010003\n").empty());
  const std::vector<std::string> found = warnings("cycles = 5\nperiod = 0.010003\n");
  REQUIRE(found.size() == 1);
  CHECK_THAT(found[0],
             Catch::Contains(
                 "a period of 0.010003 s is 1000.3 steps, so that samples once in a cycle are at another "
                 "phase of the load in each; give time.step = 9.993006993006"));
  CHECK(plan_of(box + "[[stage]]\ncycles = 5\nperiod = 0.010003\n", {"time.step=9.993006993006993e-6"})
            .warnings.empty());
}

TEST_CASE("cycles that are no multiple of the periods of their loads are warned of", "[scenario]") {
  const std::string box =
      with(discs, "duration = 1e-4\n", "") +
      "[[boundary]]\nplugin = 'box'\nname = 'cell'\ngap = 0.01\nmass = 1\nviscosity = 1\nstress = 1\n";
  const auto warnings = [&](const std::string& end, const std::string& load) {
    return plan_of(box + "[[stage]]\n" + end + "set.cell.stress_x = " + load + "\n", {"time.step=1e-5"})
        .warnings;
  };
  const std::string cycles = "cycles = 5\nperiod = 0.01\n";
  CHECK(warnings(cycles, "{ from = 1, to = 2, period = 0.01 }").empty());
  CHECK(warnings(cycles, "{ from = 1, to = 2, period = 0.005 }").empty());
  CHECK(warnings(cycles, "{ mean = 1, amplitude = 0.1, frequency_hz = 100 }").empty());
  CHECK(warnings(cycles, "{ from = 1, to = 2, duration = 0.03 }").empty());
  CHECK(warnings(cycles, "{ from = 1, to = 1, period = 0.02 }").empty());
  CHECK(warnings(cycles, "{ mean = 1, amplitude = 0, frequency_hz = 80 }").empty());
  // Of the boundary itself, and of the stage before.
  const std::string load = "stress_x = { from = 1, to = 2, period = 0.02 }\n";
  CHECK(plan_of(box + load + "[[stage]]\n" + cycles, {"time.step=1e-5"}).warnings.size() == 1);
  CHECK(plan_of(box + "[[stage]]\nduration = 0.1\nset.cell." + load + "[[stage]]\n" + cycles,
                {"time.step=1e-5"})
            .warnings.size() == 1);
  CHECK(warnings("duration = 0.03\n", "{ from = 1, to = 2, period = 0.02 }").empty());
  for (const auto& [wrong, period] :
       {std::pair{"{ from = 1, to = 2, period = 0.02 }", "0.02"},
        std::pair{"{ from = 1, to = 2, period = 0.0101 }", "0.0101"},
        std::pair{"{ mean = 1, amplitude = 0.1, frequency_hz = 80 }", "0.0125"}}) {
    const std::vector<std::string> found = warnings(cycles, wrong);
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0],
               Catch::Contains(fmt::format(
                   "cycles of 0.01 s are no whole number of the periods of cell.stress_x, {} s; give "
                   "cycles of a multiple of each period",
                   period)));
  }
}

TEST_CASE("several functions of other periods are one warning", "[scenario]") {
  const std::string scene =
      with(discs, "duration = 1e-4\n", "") +
      "[[boundary]]\nplugin = 'box'\nname = 'cell'\ngap = 0.01\n"
      "stress_x = { from = 1, to = 2, period = 0.02 }\nstress_y = { from = 1, to = 2, period = 0.03 }\n"
      "[[stage]]\ncycles = 3\nperiod = 0.01\n";
  const std::vector<std::string> found = plan_of(scene).warnings;
  REQUIRE(found.size() == 1);
  CHECK_THAT(found[0],
             Catch::Contains("of the periods of cell.stress_x, 0.02 s, of cell.stress_y, 0.03 s; give"));
}

TEST_CASE("a stage cannot change what describes the start of a boundary", "[scenario]") {
  const std::string scene =
      with(discs, "duration = 1e-4\n", "") +
      "[[boundary]]\nplugin = 'box'\nname = 'cell'\ngap = 0.01\nx = 'fixed'\ny = 'fixed'\n"
      "[[stage]]\nduration = 1\nset.cell.gap = 0.02\n";
  CHECK_THROWS_WITH(plan_of(scene),
                    Catch::Contains("'gap' describes the start, and a stage cannot change it; set "
                                    "it where 'cell' is declared"));
}

TEST_CASE("a misspelt table of stages is named, not the duration that it replaces", "[scenario]") {
  CHECK(refusal(staged("[[stages]]\nname = 'x'\n"))
            .starts_with("scene.toml:26:3: unknown key 'stages' in the file; did you mean 'stage'?"));
  CHECK(refusal(staged("")).find("[time] has no 'duration'") != std::string::npos);
}
