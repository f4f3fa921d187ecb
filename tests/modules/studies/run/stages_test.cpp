#include "run_support.hpp"

#include <atomic>
#include <cstdlib>

#include <catch2/catch.hpp>

#include <scree/run/set_up.hpp>
#include <scree/run/warnings.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::run;
using namespace scree::test;

TEST_CASE("progress to a condition is told by its quantity and goal, not by a share", "[run]") {
  Bench bench(with(discs, "duration = 1e-4\n", "") +
              "[[stage]]\nname = 'rest'\nuntil = { kinetic_over_elastic = 1e-30, at_most = 1000 }\n"
              "[[stage]]\nname = 'after'\nduration = 1\n");
  std::atomic<bool> stop = false;
  bench.options.stop = &stop;
  bench.options.on_progress = [&](const Progress& p) {
    CHECK_FALSE(p.share.has_value());
    CHECK(p.stage_number == 1);
    CHECK(p.stages == 2);
    CHECK_THAT(p.conditions,
               Catch::StartsWith("kinetic_over_elastic = ") && Catch::EndsWith(", below 1e-30"));
    stop = true;
  };
  CHECK(bench.run().interrupted);
}

TEST_CASE("run.json tells each stage, and the series number them", "[run]") {
  const std::string stages =
      "[[stage]]\nname = 'a'\nduration = 4e-5\n"
      "[[stage]]\nname = 'b'\nuntil = { kinetic_over_elastic = 1e30, at_most = 1 }\n"
      "[[stage]]\nname = 'c'\nduration = 2e-5\n";
  const Bench bench(with(discs, "duration = 1e-4\n", "") + stages);
  const std::vector<StageResult> told = bench.run().stages;
  REQUIRE(told.size() == 3);
  CHECK(told[0].steps == 4);
  CHECK(told[0].ended == "duration");
  CHECK(told[1].name == "b");
  CHECK(told[1].start == told[0].end);
  CHECK(told[1].steps % 100 == 0);  // a condition is tested every 100 steps
  CHECK(told[1].ended == "condition");
  CHECK(told[2].start == told[1].end);
  CHECK(told[2].end == Approx(told[2].start + 2e-5));
  const std::string series = text_of(bench.options.out / "series/energy.csv");
  CHECK(series.substr(0, series.find('\n')).ends_with(",residual [J],stage"));
  CHECK(series.ends_with(",3\n"));
  CHECK(text_of(bench.options.out / "run.json").find("\"ended\": \"condition\"") != std::string::npos);
  const Bench single;
  single.run();
  CHECK(text_of(single.options.out / "series/energy.csv").find("stage") == std::string::npos);
}

TEST_CASE("the time for pictures and series is not counted as stepping", "[run]") {
  const Bench bench(discs, {"probe.every=1e-5"});
  const RunResult result = bench.run();
  CHECK(result.output > 0);
  CHECK(result.output < result.wall);
  CHECK(result.particle_steps_per_second == Approx(90 / (result.wall - result.output)));
}

namespace {

// Discs that touch each other and a box whose walls a stage may move, and move about under gravity.
const std::string sliding =
    with(with(with(with(discs, "duration = 1e-4\n", "expected_speed = 1\n"), "gap = 0.1", "gap = 0.0"),
              "gap = 0.005", "gap = 0"),
         "normal_damping = 0\n",
         "normal_damping = 0.5\ntangential_stiffness = 5e3\nstatic_friction = 0.4\n") +
    "[[body_force]]\nplugin = 'gravity'\nacceleration = [1, -10]\n";
const std::string packing =
    "lattice = { kind = 'square', count = [3, 3], gap = 0.0 }\nradius = 0.01\nrandom_velocity = 0.1\n";
const std::string preparation = "[[stage]]\nduration = 6e-3\n";

// The scene that begins from the state at the end of a run.
std::string from_state(const Bench& prepared) {
  ::setenv("SCREE_STATE_PATH", prepared.options.out.c_str(), 1);
  return with(sliding, packing, "state = '" + (prepared.options.out / "final_state.h5").string() + "'\n");
}

// The results of a run as they are written.
std::string results_of(const Bench& bench) {
  bench.run();
  return text_of(bench.options.out / "series/energy.csv") + text_of(bench.options.out / "final_packing.csv");
}

}  // namespace

TEST_CASE("what the first stage sets holds from the start, as if the scene had it", "[run]") {
  const std::string stage = "[[stage]]\nname = 'on'\nduration = 4e-4\n";
  // What the first stage sets, and the same in the scene.
  const auto [set, place, given] = GENERATE(table<const char*, const char*, const char*>(
      {{"set.linear_spring_dashpot.static_friction = 0.8\n", "static_friction = 0.4\n",
        "static_friction = 0.8\n"},
       {"set.linear_spring_dashpot.static_friction = 0.02\n", "static_friction = 0.4\n",
        "static_friction = 0.02\n"},
       {"set.linear_spring_dashpot.normal_stiffness = 2e4\n", "normal_stiffness = 1e4\n",
        "normal_stiffness = 2e4\n"},
       {"set.linear_spring_dashpot.normal_damping = 2\n", "normal_damping = 0.5\n", "normal_damping = 2\n"},
       {"set.gravity.acceleration = [0, 0]\n", "acceleration = [1, -10]\n", "acceleration = [0, 0]\n"},
       {"set.box = { y_high = 'velocity', velocity_y_high = 3 }\n", "y_high = 'fixed'\n",
        "y_high = 'velocity'\nvelocity_y_high = 3\n"},
       {"set.box = { y_high = 'stress', stress = 500 }\n", "y_high = 'fixed'\n",
        "y_high = 'stress'\nstress = 500\n"}}));
  INFO(set);
  const bool new_packing = GENERATE(true, false);
  const Bench prepared(sliding + preparation);
  if (!new_packing) prepared.run();
  const std::string begin = new_packing ? sliding : from_state(prepared);
  const Bench by_stage(begin + stage + set), by_scene(with(begin, place, given) + stage);
  CHECK(results_of(by_stage) == results_of(by_scene));
  ::unsetenv("SCREE_STATE_PATH");
}

TEST_CASE("springs of a state outlive a friction of the scene that the first stage replaces", "[run]") {
  const Bench prepared(sliding + preparation);
  prepared.run();
  const std::string begin = with(from_state(prepared), "static_friction = 0.4\n", "static_friction = 0.01\n");
  const auto simulation_of = [&](const std::string& stage) { return set_up(plan_of(begin + stage)); };
  const auto kept =
      simulation_of("[[stage]]\nduration = 1e-4\nset.linear_spring_dashpot.static_friction = 0.4\n");
  CHECK(kept->energy().elastic_tangential > 0);
  CHECK(kept->let_go().empty());
  const auto cut = simulation_of("[[stage]]\nduration = 1e-4\n");
  CHECK(cut->energy().elastic_tangential < 0.1 * kept->energy().elastic_tangential);
  REQUIRE(cut->let_go().size() == 1);
  CHECK(start_warnings(plan_of(begin + "[[stage]]\nduration = 1e-4\n"), *cut).back() == cut->let_go()[0]);
  ::unsetenv("SCREE_STATE_PATH");
}
