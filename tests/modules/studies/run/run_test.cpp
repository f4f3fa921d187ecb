#include "run_support.hpp"

#include <atomic>
#include <sstream>

#include <catch2/catch.hpp>

#include <scree/run/set_up.hpp>
#include <scree/scene_record.hpp>
#include <scree/state_file/state_file.hpp>

using namespace scree;
using namespace scree::scenario;
using namespace scree::run;
using namespace scree::test;
namespace fs = std::filesystem;

namespace {

double value(const RunResult& result, const std::string& name) {
  for (const auto& [key, number] : result.quantities)
    if (key == name) return number;
  return -1;
}

}  // namespace

TEST_CASE("a run writes its series, run.json and its final packing", "[run]") {
  const Bench bench;
  const RunResult result = bench.run();
  CHECK(value(result, "steps") == 10);
  CHECK(value(result, "time") == Approx(1e-4));
  CHECK_FALSE(result.interrupted);
  const std::string series = text_of(bench.options.out / "series/energy.csv");
  CHECK(series.starts_with("time [s],kinetic_translation [J],kinetic_rotation [J],"));
  CHECK(lines_of(series).size() == 1 + 6);  // header, t = 0, 2e-5, ..., 1e-4
  CHECK(text_of(bench.options.out / "run.json").find("\"status\": \"finished\"") != std::string::npos);
  CHECK(fs::exists(bench.options.out / "final_packing.csv"));
  CHECK_FALSE(fs::exists(bench.options.out / "snapshots"));
}

TEST_CASE("the resolved scenario and the final packing of a run can be run again", "[run]") {
  const Bench bench(discs, {"scene.seed=5"});
  const RunResult first = bench.run();
  RunOptions options;
  options.out = bench.folder / "again";
  const Plan same = read_plan(bench.options.out / "scenario.toml", {}, host());
  CHECK(run_plan(same, options).state_hash == first.state_hash);
  const std::string file = "file = '" + (bench.options.out / "final_packing.csv").string() + "'\n";
  const Plan on = plan_of(with(discs,
                               "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = 0.01\n"
                               "random_velocity = 0.1\n",
                               file));
  REQUIRE(on.scene.bodies.size() == 9);
  CHECK(on.scene.bodies[0].velocity[0] != 0);
}

TEST_CASE("a probe samples only in its stages, each time once", "[run]") {
  const Bench bench(
      with(with(discs, "duration = 1e-4\n", ""), "every = 2e-5", "every = 2e-5\nstages = ['b', 'c']") +
      "[[stage]]\nname = 'a'\nduration = 1e-4\n[[stage]]\nname = 'b'\nduration = 1e-4\n"
      "[[stage]]\nname = 'c'\nduration = 4e-5\n");
  bench.run();
  std::istringstream rows(text_of(bench.options.out / "series/energy.csv"));
  std::vector<double> times;
  std::string line;
  std::getline(rows, line);
  while (std::getline(rows, line)) times.push_back(std::stod(line));
  REQUIRE(times.size() == 8);  // 1.0, 1.2, ..., 2.0, 2.2, 2.4 in 1e-4 s
  for (std::size_t k = 0; k < times.size(); ++k) CHECK(times[k] == Approx(1e-4 + 2e-5 * double(k)));
}

TEST_CASE("a run reports its start once and has the same bits with more threads", "[run][threads]") {
  Bench one, two;
  int starts = 0;
  one.options.on_start = [&](const Simulation& s) { starts += s.steps() == 0 ? 1 : 100; };
  two.options.threads = 2;
  CHECK(one.run().state_hash == two.run().state_hash);
  CHECK(starts == 1);
}

TEST_CASE("a stopped run saves its results", "[run]") {
  Bench bench(discs, {"time.duration=1000"});
  std::atomic<bool> stop = false;
  bench.options.stop = &stop;
  bench.options.on_progress = [&](const Progress& p) {
    CHECK(p.stage == "run");
    CHECK(p.share < 1);
    stop = true;
  };
  const RunResult result = bench.run();
  CHECK(result.interrupted);
  CHECK(result.verdicts.empty());
  CHECK(text_of(bench.options.out / "run.json").find("\"status\": \"interrupted\"") != std::string::npos);
  CHECK(fs::exists(bench.options.out / "final_packing.csv"));
}

TEST_CASE("an end condition that is not reached is a failure that keeps the results", "[run]") {
  const Bench bench(with(discs, "duration = 1e-4\n", "") +
                    "[[stage]]\nname = 'rest'\nuntil = { kinetic_over_elastic = 1e-30, at_most = 1e-3 }\n");
  try {
    bench.run();
    FAIL("the run should not end");
  } catch (const Error& error) {
    CHECK(error.status() == ExitStatus::not_reached);
    CHECK(std::string(error.what()).starts_with("stage 'rest': after 0.001 s kinetic_over_elastic is "));
  }
  CHECK(text_of(bench.options.out / "run.json").find("\"error\": \"stage 'rest': ") != std::string::npos);
  CHECK(text_of(bench.options.out / "run.json").find("\"ended\": \"failed\"") != std::string::npos);
  CHECK(lines_of(text_of(bench.options.out / "series/energy.csv")).size() > 10);
}

// A disc falls through a plane that is absent and cannot come back; the earlier checkpoint allows a shorter
// fall.
TEST_CASE("a stage that cannot begin leaves the state at the end of the stage before in states/", "[run]") {
  Bench bench(
      "[scene]\ndimension = 2\n[time]\nstep = 1e-3\n[[material]]\nname = 'a'\ndensity = 1000\n"
      "[[contact]]\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1e3\nnormal_damping = 0\n"
      "[[particle]]\nposition = [0, 0.1]\nvelocity = [0, -1]\nradius = 0.01\n"
      "[[boundary]]\nname = 'gate'\nplugin = 'plane'\npoint = [0, 0]\nnormal = [0, 1]\ncontrol = 'absent'\n"
      "[[stage]]\nname = 'open'\nduration = 0.2\n[[stage]]\nname = 'close'\nduration = 0.1\n"
      "set.gate.control = 'fixed'\n[checkpoint]\nevery_time = 0.05\n");
  try {
    bench.run();
    FAIL("the gate is not beyond the disc");
  } catch (const Error& error) {
    CHECK(error.status() == ExitStatus::not_reached);
    CHECK_THAT(error.what(), Catch::StartsWith("stage 'close': wall gate is to be there again"));
  }
  CHECK(present_bodies(state_file::read_state(bench.options.out / "states/open.h5"))[0].position[1] ==
        Approx(-0.1));
}

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

TEST_CASE("the scenario of a run that started from a packing can be run again from its folder", "[run]") {
  const TemporaryFolder folder;
  folder.write("bodies.csv", "x,y,radius\n0,0,0.01\n1,0,0.01\n");
  const std::string text = with(discs,
                                "lattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = 0.01\n"
                                "random_velocity = 0.1\n",
                                "file = 'bodies.csv'\n");
  const Plan plan = read_plan(folder.write("scene.toml", text), {}, host());
  RunOptions options;
  options.out = folder / "out";
  const RunResult first = run_plan(plan, options);
  const Plan same = read_plan(options.out / "scenario.toml", {}, host());
  options.out = folder / "again";
  CHECK(run_plan(same, options).state_hash == first.state_hash);
}
